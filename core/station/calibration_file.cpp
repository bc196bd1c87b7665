// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/calibration_file.h"

#include "core/base/text.h"
#include "core/calibration/record_text.h"
#include "core/memory/memory_file.h"
#include "core/profile/text_file.h"

#include <QFile>

#include <utility>

namespace boresight {
namespace {

Result<> write(const QString& path, const calibration::CalibrationHistory& history)
{
    return calibration::toText(history).and_then(
        [&](const std::string& text) { return profile::writeFile(path, QByteArray::fromStdString(text)); });
}

}  // namespace

QString calibrationPath(const QString& stateDir, const QString& mountName, bool simulated)
{
    return QStringLiteral("%1/%2%3.calibrations.toml")
        .arg(stateDir, memory::safeFileName(mountName), simulated ? QStringLiteral(".simulated") : QString());
}

CalibrationFile::CalibrationFile(const QString& path, QObject* parent) : QObject(parent), m_path(path)
{
    m_writer.setMaxThreadCount(1);
    m_writer.setExpiryTimeout(-1);
    connect(this, &CalibrationFile::written, this, &CalibrationFile::finishWriting, Qt::QueuedConnection);
    load();
}

CalibrationFile::~CalibrationFile()
{
    flush();
}

void CalibrationFile::load()
{
    if (m_path.isEmpty() || !QFile::exists(m_path)) {
        return;  // nothing was ever applied
    }
    const auto history = profile::readFile(m_path).and_then([&](const QByteArray& bytes) {
        return calibration::parseHistory({bytes.constData(), static_cast<std::size_t>(bytes.size())},
                                         m_path.toStdString());
    });
    if (history) {
        m_history = *history;
        return;
    }
    m_unreadable = true;
    m_problem = Text::tr("the calibrations of before cannot be read, and new ones are kept in memory only: %1")
                    .arg(toQString(history.error().text));
}

void CalibrationFile::save()
{
    if (m_path.isEmpty() || m_unreadable) {
        return;
    }
    if (m_writing) {
        m_again = true;
    } else {
        startWriting();
    }
}

void CalibrationFile::startWriting()
{
    m_writing = true;
    m_writer.start([this, path = m_path, history = m_history, outcome = m_outcome] {
        *outcome = write(path, history);
        Q_EMIT written();
    });
}

void CalibrationFile::finishWriting()
{
    const Result<> result = *m_outcome;
    m_writing = false;
    m_problem =
        result ? QString() : Text::tr("the calibrations could not be written: %1").arg(toQString(result.error().text));
    if (std::exchange(m_again, false)) {
        startWriting();
    }
}

void CalibrationFile::flush()
{
    m_writer.waitForDone();
    if (std::exchange(m_again, false)) {
        *m_outcome = write(m_path, m_history);
    }
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
