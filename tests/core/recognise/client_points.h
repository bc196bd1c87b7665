// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognise/recognise.h"
#include "core/targets/target_path.h"
#include "core/units/angle_between.h"
#include "tests/fakes/low_orbit.h"

#include <cmath>
#include <random>

// Points as clients send them, and a sky full of satellites.
namespace boresight::fakes {

// The same satellites in each run: most are low, some are high or on long ellipses.
inline recognise::SharedSatellites manySatellites(int count, UtcTime epoch)
{
    std::mt19937 random(17);
    const auto between = [&](double from, double to) {
        return from + (to - from) * static_cast<double>(random()) / 4294967296.0;
    };
    auto all = std::make_shared<std::vector<orbit::ElementSet>>();
    for (int i = 0; i < count; ++i) {
        orbit::ElementSet set =
            lowOrbit(epoch, Angle::fromDegrees(between(0.0, 360.0)), Angle::fromDegrees(between(0.0, 360.0)));
        set.number = 10'000 + i;
        set.name = "SAT " + std::to_string(set.number);
        set.inclination = Angle::fromDegrees(between(20.0, 100.0));
        set.revolutionsPerDay = between(12.5, 15.6);
        if (i % 20 == 0) {
            set.revolutionsPerDay = 2.0;
            set.eccentricity = i % 40 == 0 ? 0.7 : 0.001;
        }
        all->push_back(set);
    }
    return all;
}

struct ClientHabit
{
    Angle step = Angle::fromDegrees(0.01);  // of the numbers that it sends
    Seconds clock{0.0};                     // error of its clock
    Angle ahead = {};                       // it aims ahead by this, and sends the next point after twice this way
    Seconds period{1.0};                    // without a threshold
};

inline SkyPointing rounded(const SkyPointing& direction, Angle step)
{
    const auto round = [step](Angle angle) {
        return Angle::fromDegrees(std::round(angle.degrees() / step.degrees()) * step.degrees());
    };
    return {.azimuth = round(direction.azimuth), .elevation = round(direction.elevation)};
}

// `count` points of a client that tracks the target from this time.
inline recognise::SentPoints pointsOf(const targets::Target& target, const Site& site, UtcTime from, int count,
                                      const ClientHabit& habit = {})
{
    targets::TargetPath path(target, site);
    const auto later = [](UtcTime utc, Seconds time) { return utc + std::chrono::round<UtcTime::duration>(time); };
    const auto at = [&](UtcTime utc) { return path.at(later(utc, habit.clock)).value(); };
    // The time that the target needs for this way.
    const auto timeFor = [&](UtcTime utc, Angle way) {
        Seconds time{0.0};
        while (angleBetween(at(utc), at(later(utc, time))) < way) {
            time += Seconds(0.1);
        }
        return time;
    };
    recognise::SentPoints points;
    UtcTime utc = from;
    for (int i = 0; i < count; ++i) {
        const Seconds ahead = timeFor(utc, habit.ahead);
        points.push_back({.utc = utc, .direction = rounded(at(later(utc, ahead)), habit.step)});
        utc = later(utc, habit.ahead > Angle{} ? timeFor(utc, 2.0 * habit.ahead) : habit.period);
    }
    return points;
}

}  // namespace boresight::fakes
