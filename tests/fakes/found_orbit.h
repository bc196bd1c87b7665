// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/orbit/sgp4.h"
#include "core/orbit/topocentric.h"
#include "core/passes/pass_finder.h"
#include "tests/fakes/low_orbit.h"

#include <gtest/gtest.h>

#include <functional>

namespace boresight::fakes {

struct FoundOrbit
{
    orbit::ElementSet elements;
    passes::Pass pass;
};

// The first circular orbit at 420 km that has such a pass within two hours.
inline FoundOrbit orbitWith(const Site& site, UtcTime now, const std::function<bool(const passes::Pass&)>& wanted)
{
    for (int node = 0; node < 360; node += 5) {
        for (int anomaly = 0; anomaly < 360; anomaly += 5) {
            const orbit::ElementSet elements = lowOrbit(now, Angle::fromDegrees(node), Angle::fromDegrees(anomaly));
            const auto list = passes::findPasses(
                orbit::Sgp4(elements), {.site = site, .from = now, .to = now + std::chrono::hours(2), .isClear = {}});
            if (!list.passes.empty() && wanted(list.passes.front())) {
                return {.elements = elements, .pass = list.passes.front()};
            }
        }
    }
    ADD_FAILURE() << "no orbit has such a pass";
    return {};
}

inline SkyPointing directionOf(const FoundOrbit& found, const Site& site, UtcTime utc)
{
    const orbit::JulianDate date = orbit::julianDate(utc);
    const auto state = orbit::Sgp4(found.elements).propagate(date);
    return orbit::Observer(site).look(orbit::groundState(*state, date)).direction;
}

}  // namespace boresight::fakes
