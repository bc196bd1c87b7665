// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/north/calibration_file.h"

#include "core/base/file_name.h"
#include "core/base/text.h"
#include "core/calibration/record_text.h"
#include "core/profile/small_file.h"

#include <QFile>

#include <utility>

namespace boresight {
namespace {

const QString kEnding = QStringLiteral(".calibrations.toml");

// An empty history if nothing was ever applied.
Result<calibration::CalibrationHistory> read(const QString& path)
{
    if (!QFile::exists(path)) {
        return calibration::CalibrationHistory{};
    }
    return profile::readFile(path).and_then([&](const QByteArray& bytes) {
        return calibration::parseHistory({bytes.constData(), static_cast<std::size_t>(bytes.size())}, path);
    });
}

Result<> writeOne(const QString& path, const calibration::CalibrationHistory& history)
{
    return calibration::toText(history).and_then(
        [&](const std::string& text) { return profile::writeFile(path, QByteArray::fromStdString(text)); });
}

// Writes no empty file: no file of points without a point, no history without an entry.
Result<> write(const QString& path, const calibration::CalibrationHistory& history,
               const calibration::CalibrationRecord& points)
{
    Result<> written;
    if (!history.entries().empty()) {
        written = writeOne(path, history);
    }
    if (const QString file = pointsPath(path); !points.points.empty() || QFile::exists(file)) {
        const Result<> kept = writeOne(file, calibration::CalibrationHistory({points}, 0));
        written = written ? kept : written;
    }
    return written;
}

}  // namespace

QString calibrationPath(const QString& stateDir, const QString& mountName, bool simulated)
{
    return QStringLiteral("%1/%2%3").arg(stateDir, safeFileName(mountName),
                                         simulated ? QStringLiteral(".simulated") : QString()) +
           kEnding;
}

QString pointsPath(const QString& calibrations)
{
    return calibrations.chopped(kEnding.size()) + QStringLiteral(".points.toml");
}

CalibrationFile::CalibrationFile(const QString& path, QObject* parent) : QObject(parent), m_path(path)
{
    connect(&m_writer, &NewestWriter::written, this, [this] { m_problem.clear(); });
    connect(&m_writer, &NewestWriter::failed, this, [this](const QString& reason) {
        m_problem = Text::tr("The calibrations could not be written: %1").arg(reason);
    });
    load();
}

void CalibrationFile::load()
{
    if (m_path.isEmpty()) {
        return;
    }
    const auto history = read(m_path);
    m_history = history.value_or(calibration::CalibrationHistory{});
    const auto points = read(pointsPath(m_path));
    if (points && !points->entries().empty()) {
        m_points = points->entries().front();
    }
    if (!history || !points) {
        m_unreadable = true;
        m_problem =
            Text::tr("The stored calibrations cannot be read: %1").arg((history ? points : history).error().text);
    }
}

void CalibrationFile::keepPoints(calibration::CalibrationRecord points)
{
    m_points = std::move(points);
    save();
}

void CalibrationFile::save()
{
    if (!m_path.isEmpty() && !m_unreadable) {
        m_writer.write(
            [path = m_path, history = m_history, points = m_points] { return write(path, history, points); });
    }
}

void CalibrationFile::flush()
{
    (void)m_writer.flush();
}

void CalibrationFile::add(calibration::CalibrationRecord record)
{
    m_history.add(std::move(record));
    save();
}

const calibration::CalibrationRecord& CalibrationFile::undo()
{
    const calibration::CalibrationRecord& record = m_history.undo();
    save();
    return record;
}

const calibration::CalibrationRecord& CalibrationFile::redo()
{
    const calibration::CalibrationRecord& record = m_history.redo();
    save();
    return record;
}

}  // namespace boresight

#include "moc_calibration_file.cpp"
