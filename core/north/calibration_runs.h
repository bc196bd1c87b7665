// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/north/offset_run.h"
#include "core/north/scan_pilot.h"
#include "core/north/swing_pilot.h"

#include <optional>
#include <utility>

// The present run: the average of the sensor, the swing of the compass or the cross scan, one at a time. Starts and
// leads the run, and keeps how the last one ended. A run that ended by itself waits in takeEnd() for the caller who
// uses its result, and is over with close(). Station thread only.
namespace boresight {

class CalibrationRuns
{
public:
    // All arguments must outlive this object.
    CalibrationRuns(StationControl& control, const profile::InForce& profile, const LiveSensor& sensor,
                    const AxisObserver& axes, BodyFollower& follower, const Clock& clock, EventLog& log);

    [[nodiscard]] CalibrationRun running() const;
    [[nodiscard]] bool runs() const { return running() != CalibrationRun::None; }
    [[nodiscard]] Result<> isIdle() const;
    // A run is moving the mount.
    [[nodiscard]] bool moves() const { return m_swing.run().has_value() || m_scan.run().has_value(); }

    [[nodiscard]] Result<> mayAverage() const;
    Result<> startOffset();
    void planSwing(const SwingWish& wish) { m_swing.plan(wish); }
    Result<> startSwing(const SwingWish& wish);
    // The body is tracked, and a scan could start now.
    [[nodiscard]] Result<> mayScan(ephemeris::Body body) const;
    // Call it only if mayScan() allows it and the width is valid for a scan.
    Result<> startScan(ephemeris::Body body, Angle width);
    Result<> givePower(double decibels);

    // A new value of the sensor.
    void take(const orientation::Orientation& value);
    void take(const power::Value& value) { m_scan.take(value); }
    void show(const PowerLineStatus& line) { m_scan.show(line); }
    // Once per tick, after the axes were observed and the body was tracked. True: the status has changed.
    [[nodiscard]] bool tick();

    // The end of the run that ended by itself.
    [[nodiscard]] std::optional<RunEnd> takeEnd() { return std::exchange(m_end, std::nullopt); }
    void close(const QString& outcome, bool failed);
    // Ends the run for a reason from outside: the mount holds.
    void breakOff(const QString& why);

    // The plan also names the obstacles.
    [[nodiscard]] SwingPlan swingPlan() const;
    [[nodiscard]] std::vector<calibration::SwingDot> swingSoFar() const;
    [[nodiscard]] bool wantsPower() const;
    [[nodiscard]] CalibrationProgress progress() const;
    [[nodiscard]] const SwingPilot& swing() const { return m_swing; }
    [[nodiscard]] const ScanPilot& scan() const { return m_scan; }

private:
    [[nodiscard]] Result<> followsNothing() const;
    [[nodiscard]] Result<> maySwing() const;
    [[nodiscard]] std::optional<RunEnd> stepOffset() const;
    void ended(std::optional<RunEnd> end);
    Result<> endedBy(const Result<>& scan);
    void hold();

    StationControl& m_control;
    const profile::InForce& m_profile;
    const LiveSensor& m_sensor;
    const AxisObserver& m_axes;
    BodyFollower& m_follower;
    const Clock& m_clock;
    EventLog& m_log;
    std::optional<OffsetRun> m_offset;
    SwingPilot m_swing;
    ScanPilot m_scan;
    std::optional<RunEnd> m_end;
    QString m_outcome;  // of the last run
    bool m_failed = false;
};

}  // namespace boresight
