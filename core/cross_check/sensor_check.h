// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/units/sky.h"

#include <algorithm>
#include <array>
#include <deque>
#include <optional>

// Compares the sensor with the axes, both as true directions. A value of the sensor is an average and some time old
// when it arrives. So it is compared with the position of the axes at that time, and their motion around that time is
// allowed for. A difference counts if it lasts and at least two values have it. A single outlier never counts. Pure;
// station thread.
namespace boresight {

// Near the zenith a compass on the boom is useless. Beyond it the box is upside down and shows the opposite direction.
inline constexpr Angle kHighestForCompass = Angle::fromDegrees(75.0);

struct SensorCheckSettings
{
    Angle threshold;
    Seconds time{0.0};       // a longer difference counts as lasting
    Seconds latency{0.0};    // of the azimuth: age of the middle of its average at arrival
    Seconds averaging{0.0};  // of the azimuth

    bool operator==(const SensorCheckSettings&) const = default;
};

struct SensorDirection
{
    SkyPointing direction;  // true
    SteadyTime arrival;
    bool azimuthCounts = true;  // false: the compass is not calibrated
    bool elevationCounts = true;
};

class SensorCheck
{
public:
    // The result for one axis. Azimuth and elevation are independent: one may agree while the other does not.
    struct Difference
    {
        std::optional<Angle> now;  // sensor minus axes; empty: not compared
        bool beyond = false;       // now above the threshold
        bool lasts = false;
        bool beganMoving = false;  // began while the axes moved
    };

    // The range of an axis during a span of time.
    struct Passed
    {
        Angle least;
        Angle mean;
        Angle most;

        [[nodiscard]] Angle spread() const { return std::max(most - mean, mean - least); }
    };

    explicit SensorCheck(const SensorCheckSettings& settings) : m_settings(settings) {}
    // Applies from the next value on. The class knows no profile, so it can also check a proposed mounting.
    void setSettings(const SensorCheckSettings& settings) { m_settings = settings; }

    // The mount does not have this axis, so the axis is not compared.
    void leaveOut(Axis axis) { m_missing = axis; }

    // Where the axes point, once per tick. Empty: unknown; values that overlap such a time are not compared.
    void note(SteadyTime now, const std::optional<SkyPointing>& axes);
    void take(const SensorDirection& reading);
    // Advances the time. A difference may become a lasting one between two values.
    void tick(SteadyTime now);
    // The sensor is gone or was replaced.
    void forget();

    // The azimuths of the axes, of any turn, while a value was measured that arrived at this time. Empty: unknown.
    [[nodiscard]] std::optional<Passed> azimuthsOf(SteadyTime arrival) const;
    [[nodiscard]] const Difference& difference(Axis axis) const { return m_cases[index(axis)].difference; }
    [[nodiscard]] bool disagrees() const { return m_cases[0].difference.lasts || m_cases[1].difference.lasts; }

private:
    struct Place
    {
        SteadyTime time;
        Angle azimuth;  // unwrapped
        Angle elevation;
    };
    struct Case
    {
        Difference difference;
        std::optional<SteadyTime> since;  // time of the first of the consecutive values that differ
        int differing = 0;
        int agreeing = 0;
    };

    [[nodiscard]] std::optional<Passed> passed(Angle Place::*angle, SteadyTime middle, Seconds width) const;
    [[nodiscard]] bool moves(SteadyTime since) const;
    void judge(Case& which, const std::optional<Angle>& difference, Angle excess, SteadyTime arrival);

    SensorCheckSettings m_settings;
    std::optional<Axis> m_missing;
    std::deque<Place> m_places;  // of the last seconds
    std::array<Case, 2> m_cases;
};

}  // namespace boresight
