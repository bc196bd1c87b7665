// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/units/sky.h"

#include <array>
#include <deque>
#include <optional>

// Compares the sensor with the axes, both as true directions. A value of the sensor is old when it arrives, and an
// average: so it is compared with where the axes were then, and as much as they moved about that time is forgiven. A
// difference counts when it lasts and at least two values have it; a single outlier never does. Pure; station thread.
namespace boresight {

// Near the zenith a compass on the boom says nothing, and beyond it the box lies on its back and says the opposite.
inline constexpr Angle kHighestForCompass = Angle::fromDegrees(75.0);

struct SensorCheckSettings
{
    Angle threshold;
    Seconds time{0.0};       // how long the difference may last
    Seconds latency{0.0};    // of the azimuth: age of the middle of its average on arrival
    Seconds averaging{0.0};  // of the azimuth

    bool operator==(const SensorCheckSettings&) const = default;
};

struct SensorDirection
{
    SkyPointing direction;  // true
    SteadyTime arrival;
    bool azimuthCounts = true;  // else its compass is not calibrated
    bool elevationCounts = true;
};

class SensorCheck
{
public:
    // Azimuth and elevation apart: one may be right while the other is not.
    struct Difference
    {
        std::optional<Angle> now;  // sensor minus axes; empty: not compared
        bool beyond = false;       // the threshold, now
        bool lasts = false;
        bool beganMoving = false;  // it began while the axes moved
    };

    explicit SensorCheck(const SensorCheckSettings& settings) : m_settings(settings) {}
    // From the next value on. It knows no profile: the same check judges a mounting that is only proposed.
    void setSettings(const SensorCheckSettings& settings) { m_settings = settings; }

    // The mount has no such axis: it is not compared.
    void leaveOut(Axis axis) { m_missing = axis; }

    // Where the axes point, once per tick; empty: not known, and nothing is compared across that.
    void note(SteadyTime now, const std::optional<SkyPointing>& axes);
    void take(const SensorDirection& reading);
    // Time goes on: a difference becomes a lasting one between two values too.
    void tick(SteadyTime now);
    // There is no sensor any more, or another.
    void forget();

    [[nodiscard]] const Difference& difference(Axis axis) const { return m_cases[index(axis)].difference; }
    [[nodiscard]] bool disagrees() const { return m_cases[0].difference.lasts || m_cases[1].difference.lasts; }

private:
    struct Place
    {
        SteadyTime time;
        Angle azimuth;  // unwrapped
        Angle elevation;
    };
    // Where an axis was within a span of time.
    struct Passed
    {
        Angle mean;
        Angle spread;  // to either side
    };
    struct Case
    {
        Difference difference;
        std::optional<SteadyTime> since;  // the first value of those in a row that differ
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
