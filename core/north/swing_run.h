// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/swing_tally.h"
#include "core/messages/request.h"
#include "core/north/axis_trace.h"
#include "core/north/swing_plan.h"
#include "core/orientation/orientation.h"
#include "core/profile/sensor_settings.h"

#include <memory>
#include <optional>
#include <vector>

// One swing of the compass: says which motion comes next, keeps the readings that are fit for use, and fits them in the
// end. It moves nothing itself, and knows nothing of STOP: the caller carries out its motions and reports their end.
// Pure; station thread. More than 15 members: the plan, the place in it and the readings, which all begin and end with
// one swing.
namespace boresight {

// One value of the sensor with the axes as they were when it was measured.
struct SwingReading
{
    orientation::Orientation value;
    AxesThen about;  // the time of its heading
    AxesThen level;  // the time of its elevation, which is younger
};

// What a swing found, also where the compass is of no use.
struct SwungCompass
{
    std::shared_ptr<const SwingOutcome> outcome;
    QString doubt;  // why it may be wrong; mostly empty
};

class SwingRun
{
public:
    SwingRun(const SwingPlan& plan, const AxisPosition& here, const tracking::MotionLimits& limits,
             const profile::SensorSettings& sensor, SteadyTime now);

    // A sensor that falls silent is waited for so long in all, at rest: as a broker or a WiFi needs to come back.
    static constexpr Seconds kLongestWait{30.0};

    // What is to be asked of the mount now; mostly nothing. `heard`: the sensor is.
    [[nodiscard]] std::optional<Request> step(SteadyTime now, const AxesThen& axes, bool heard);
    void take(const SwingReading& reading);

    // Something was asked of the mount.
    [[nodiscard]] bool begun() const { return m_begun || m_leg > 0; }
    [[nodiscard]] bool done() const { return m_leg == m_legs.size(); }
    [[nodiscard]] bool waits() const { return m_waitsSince.has_value(); }
    [[nodiscard]] Seconds waitLeft(SteadyTime now) const;
    [[nodiscard]] bool waitedInVain(SteadyTime now) const { return waits() && waitLeft(now) <= Seconds(0.0); }
    // Longer than planned by far: something holds the mount.
    [[nodiscard]] bool late(SteadyTime now) const { return !waits() && now > m_deadline; }
    [[nodiscard]] double part(SteadyTime now) const;
    [[nodiscard]] Seconds left(SteadyTime now) const;
    [[nodiscard]] QString text(SteadyTime now) const;
    [[nodiscard]] const calibration::SwingLimits& limits() const { return m_fit; }
    // The readings so far. `sense`: as long as they do not show which way the sensor counts.
    [[nodiscard]] std::vector<calibration::SwingDot> dots(calibration::AzimuthSense sense) const;

    // It was never silent, or it reports its calibration, where a restart would be seen.
    [[nodiscard]] bool heardAllAlong() const;
    // What was found: refused with the reason where it says nothing. `declination`: from magnetic to true north.
    [[nodiscard]] Result<SwingOutcome> outcome(UtcTime utc, Angle declination) const;

private:
    struct Leg
    {
        Angle to;
        AngularRate rate;  // zero: go there as fast as the mount goes
        calibration::Turning turning = calibration::Turning::Clockwise;
        bool reads = true;  // a sweep reads on its way, a stop while it dwells
    };
    void planSweep(const AxisPosition& here);
    void planStops(const AxisPosition& here);
    [[nodiscard]] bool reached(const Leg& leg, const AxesThen& axes) const;
    [[nodiscard]] std::optional<Request> begin(const Leg& leg);
    [[nodiscard]] QString countText() const;
    [[nodiscard]] bool dwells(SteadyTime now, const AxesThen& axes);
    [[nodiscard]] std::optional<Request> wait(SteadyTime now, const AxesThen& axes);
    void goOn(SteadyTime now);

    SwingPlan m_plan;
    tracking::MotionLimits m_limits;
    Angle m_inSensor;
    calibration::SwingLimits m_fit;  // what readings have to be like
    Seconds m_settling;
    std::vector<Leg> m_legs;
    std::size_t m_leg = 0;
    bool m_begun = false;                   // the present leg was asked for
    std::optional<SteadyTime> m_standsFor;  // since when, at a stop
    bool m_reads = false;
    std::optional<SteadyTime> m_waitsSince;  // for the sensor
    Seconds m_waited{0.0};                   // for it, before that
    SteadyTime m_started;                    // later by what was waited
    SteadyTime m_deadline;
    std::vector<calibration::SwingSample> m_samples;
    std::vector<calibration::LevelSample> m_levels;
};

}  // namespace boresight
