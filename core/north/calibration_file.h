// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/newest_writer.h"
#include "core/calibration/calibration_record.h"

#include <QObject>
#include <QString>

#include <vector>

// The two files of the calibration. STATE_DIR/NAME.calibrations.toml is read once when the program starts, and written
// when the operator applies, undoes or redoes a calibration. NAME.points.toml beside it keeps the points that were
// taken and not dropped yet. Saving never blocks the station thread, on which this object lives. A file that cannot be
// read is never overwritten.
namespace boresight {

class CalibrationFile final : public QObject
{
    Q_OBJECT

public:
    // An empty path: everything is kept in memory only. Blocks while it reads.
    explicit CalibrationFile(const QString& path, QObject* parent = nullptr);

    [[nodiscard]] const QString& path() const { return m_path; }
    [[nodiscard]] const calibration::CalibrationHistory& history() const { return m_history; }
    // Why the file could not be read, or could not be written the last time. Empty: no problem.
    [[nodiscard]] const QString& problem() const { return m_problem; }

    // The points from the file, and every later state of them.
    [[nodiscard]] const std::vector<calibration::CalibrationPoint>& points() const { return m_points.points; }
    [[nodiscard]] const calibration::RecordMount& pointsMount() const { return m_points.mount; }
    void keepPoints(calibration::CalibrationRecord points);

    void add(calibration::CalibrationRecord record);
    // Call these only if the history canUndo() or canRedo().
    const calibration::CalibrationRecord& undo();
    const calibration::CalibrationRecord& redo();

    // Waits until the newest value is on the disk. Call it at the end of the program, after the event loop.
    void flush();

private:
    void load();
    void save();

    QString m_path;
    calibration::CalibrationHistory m_history;
    calibration::CalibrationRecord m_points;  // the points that no calibration has used yet
    QString m_problem;
    bool m_unreadable = false;
    NewestWriter m_writer{this};
};

// The path of the points file that belongs to this file of calibrations.
[[nodiscard]] QString pointsPath(const QString& calibrations);

// The path for a mount. A simulated mount has its own file, so its results never enter the history of the real one.
[[nodiscard]] QString calibrationPath(const QString& stateDir, const QString& mountName, bool simulated);

}  // namespace boresight
