// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/calibration/calibration_record.h"

#include <QString>

// The calibrations of a mount: STATE_DIR/NAME.calibrations.toml. Read once when the program starts, written when the
// operator applies one, takes one back or brings it again: a few times a day at most, a few kilobytes, so at once.
// What cannot be read is never written over. Station thread only.
namespace boresight {

class CalibrationFile
{
public:
    // An empty folder: kept in memory only.
    CalibrationFile(const QString& stateDir, const QString& mountName);

    [[nodiscard]] const calibration::CalibrationHistory& history() const { return m_history; }
    // Why the file could not be read or written; empty while all is well.
    [[nodiscard]] const QString& problem() const { return m_problem; }

    void add(calibration::CalibrationRecord record);
    // Only where the history can.
    const calibration::CalibrationRecord& undo();
    const calibration::CalibrationRecord& redo();

private:
    void load();
    void save();

    QString m_path;
    calibration::CalibrationHistory m_history;
    QString m_problem;
    bool m_unreadable = false;
};

}  // namespace boresight
