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

// One swing of the compass: says which motion comes next, keeps the usable readings, and fits them at the end. It moves
// nothing itself and knows nothing of STOP: the caller carries out the motions and reports their end. Pure; station
// thread. It has more than 15 members: the plan, the progress in it and the readings. All of them begin and end with
// one swing.
namespace boresight {

// One value of the sensor with the position of the axes when it was measured.
struct SwingReading
{
    orientation::Orientation value;
    AxesThen about;  // the axes at the time of the heading
    AxesThen level;  // the axes at the time of the elevation, which is younger
};

// The result of a swing, also if the compass is unusable.
struct SwungCompass
{
    std::shared_ptr<const SwingOutcome> outcome;
    QString doubt;  // why the result may be wrong; usually empty
};

class SwingRun
{
public:
    SwingRun(const SwingPlan& plan, const AxisPosition& here, const tracking::MotionLimits& limits,
             const profile::SensorSettings& sensor, SteadyTime now);

    // Total time that a swing waits, standing still, for a silent sensor: enough for a broker or a WiFi to come back.
    static constexpr Seconds kLongestWait{30.0};

    // The next request to the mount; usually none. `heard`: values of the sensor arrive.
    [[nodiscard]] std::optional<Request> step(SteadyTime now, const AxesThen& axes, bool heard);
    void take(const SwingReading& reading);

    // A motion was requested from the mount.
    [[nodiscard]] bool begun() const { return m_begun || m_leg > 0; }
    [[nodiscard]] bool done() const { return m_leg == m_legs.size(); }
    [[nodiscard]] bool waits() const { return m_waitsSince.has_value(); }
    [[nodiscard]] Seconds waitLeft(SteadyTime now) const;
    [[nodiscard]] bool waitedInVain(SteadyTime now) const { return waits() && waitLeft(now) <= Seconds(0.0); }
    // Much longer than planned: something blocks the mount.
    [[nodiscard]] bool late(SteadyTime now) const { return !waits() && now > m_deadline; }
    [[nodiscard]] double part(SteadyTime now) const;
    [[nodiscard]] Seconds left(SteadyTime now) const;
    [[nodiscard]] QString text(SteadyTime now) const;
    [[nodiscard]] const calibration::SwingLimits& limits() const { return m_fit; }
    // The readings so far. `sense`: used while the readings do not show yet which way the sensor counts.
    [[nodiscard]] std::vector<calibration::SwingDot> dots(calibration::AzimuthSense sense) const;

    // The sensor was never silent, or it reports its calibration, which would reveal a restart.
    [[nodiscard]] bool heardAllAlong() const;
    // The result. Refused with the reason if the readings give none. `declination`: from magnetic to true north.
    [[nodiscard]] Result<SwingOutcome> outcome(UtcTime utc, Angle declination) const;

private:
    struct Leg
    {
        Angle to;
        AngularRate rate;  // zero: go there at full speed
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
    calibration::SwingLimits m_fit;  // limits that a reading must meet
    Seconds m_settling;
    std::vector<Leg> m_legs;
    std::size_t m_leg = 0;
    bool m_begun = false;                   // the present leg was requested
    std::optional<SteadyTime> m_standsFor;  // since when the mount stands at a stop
    bool m_reads = false;
    std::optional<SteadyTime> m_waitsSince;  // for the sensor
    Seconds m_waited{0.0};                   // earlier waits for the sensor
    SteadyTime m_started;                    // moved later by the time of all waits
    SteadyTime m_deadline;
    std::vector<calibration::SwingSample> m_samples;
    std::vector<calibration::LevelSample> m_levels;
};

}  // namespace boresight
