// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/north/axis_observer.h"
#include "core/north/live_sensor.h"
#include "core/north/run_end.h"
#include "core/north/swing_run.h"

#include <cstdint>
#include <optional>

// Moves the mount through a swing of the compass: asks StationControl for the motions that SwingRun wants, stands still
// while the sensor is silent, and notices what ends the swing. Station thread only.
namespace boresight {

class SwingPilot
{
public:
    // All arguments must outlive this object.
    SwingPilot(StationControl& control, const profile::InForce& profile, const LiveSensor& sensor,
               const AxisObserver& axes, const Clock& clock, EventLog& log);

    void plan(const SwingWish& wish) { m_wish = wish; }
    // Where a swing would turn from here.
    [[nodiscard]] SwingPlan planned() const;
    // Whether sensor and mount allow a swing.
    [[nodiscard]] Result<> mayStart() const;
    // Call it only if mayStart() allows it, with a plan without obstacle. Call tick() after it.
    void start(const SwingPlan& plan);
    void take(const SwingReading& reading);
    // Once per tick while a swing runs, after the axes were observed. Call end() after the swing has ended.
    [[nodiscard]] std::optional<RunEnd> tick();
    void end();

    // Empty: no swing runs.
    [[nodiscard]] const std::optional<SwingRun>& run() const { return m_run; }

private:
    [[nodiscard]] QString ending() const;
    [[nodiscard]] std::optional<RunEnd> askForMotion(const AxesThen& axes);
    void reportWait(bool waited, const Result<>& heard);
    void warnOfWait(const QString& why);
    [[nodiscard]] RunEnd finish() const;

    StationControl& m_control;
    const profile::InForce& m_profile;
    const LiveSensor& m_sensor;
    const AxisObserver& m_axes;
    const Clock& m_clock;
    EventLog& m_log;
    SwingWish m_wish;
    std::optional<SwingRun> m_run;
    std::uint64_t m_restarts = 0;  // restarts of the sensor until the swing began
};

}  // namespace boresight
