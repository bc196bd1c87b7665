// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/newest_writer.h"
#include "core/calibration/calibration_record.h"

#include <QObject>
#include <QString>

#include <vector>

// A file of calibrations, STATE_DIR/NAME.calibrations.toml: read once when the program starts, written when the
// operator applies one, takes one back or brings it again; and beside it, NAME.points.toml, the points that were taken
// and not dropped yet. Saving never blocks the station thread, on which this lives. What cannot be read is never
// written over.
namespace boresight {

class CalibrationFile final : public QObject
{
    Q_OBJECT

public:
    // An empty path: kept in memory only. Blocks while it reads.
    explicit CalibrationFile(const QString& path, QObject* parent = nullptr);

    [[nodiscard]] const QString& path() const { return m_path; }
    [[nodiscard]] const calibration::CalibrationHistory& history() const { return m_history; }
    // Why the file could not be read, or not be written the last time; empty while all is well.
    [[nodiscard]] const QString& problem() const { return m_problem; }

    // As they were when the file was read, and what is kept of them from now on.
    [[nodiscard]] const std::vector<calibration::CalibrationPoint>& points() const { return m_points.points; }
    [[nodiscard]] const calibration::RecordMount& pointsMount() const { return m_points.mount; }
    void keepPoints(calibration::CalibrationRecord points);

    void add(calibration::CalibrationRecord record);
    // Only where the history can.
    const calibration::CalibrationRecord& undo();
    const calibration::CalibrationRecord& redo();

    // Waits until the newest value is on the disk: at the end of the program, after the loop.
    void flush();

private:
    void load();
    void save();

    QString m_path;
    calibration::CalibrationHistory m_history;
    calibration::CalibrationRecord m_points;  // of no calibration yet
    QString m_problem;
    bool m_unreadable = false;
    NewestWriter m_writer{this};
};

// Where the points lie of whose calibrations lie there.
[[nodiscard]] QString pointsPath(const QString& calibrations);

// Of a mount. A simulated one has its own: what was found there never comes into the history of the real one.
[[nodiscard]] QString calibrationPath(const QString& stateDir, const QString& mountName, bool simulated);

}  // namespace boresight
