// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/calibration_file.h"

#include "core/base/text.h"
#include "core/calibration/record_text.h"
#include "core/memory/memory_file.h"
#include "core/profile/text_file.h"

#include <QFile>

namespace boresight {

CalibrationFile::CalibrationFile(const QString& stateDir, const QString& mountName)
{
    if (!stateDir.isEmpty()) {
        m_path = stateDir + QLatin1Char('/') + memory::safeFileName(mountName) + QStringLiteral(".calibrations.toml");
        load();
    }
}

void CalibrationFile::load()
{
    if (!QFile::exists(m_path)) {
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
    const Result<> written = calibration::toText(m_history).and_then(
        [this](const std::string& text) { return profile::writeFile(m_path, QByteArray::fromStdString(text)); });
    m_problem = written ? QString()
                        : Text::tr("the calibrations could not be written: %1").arg(toQString(written.error().text));
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
