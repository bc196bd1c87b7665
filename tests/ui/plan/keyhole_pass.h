// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/passes/pass_finder.h"
#include "core/profile/profile.h"
#include "core/targets/target.h"
#include "tests/fakes/low_orbit.h"
#include "ui/plan/pass_planner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <memory>

// A satellite that passes almost through the zenith, and a mount that is too slow for it.
namespace boresight::ui {

inline const Site kKeyholeSite{.latitude = 38.757_deg, .longitude = -9.117_deg, .heightMetres = 80.0};

struct KeyholePass
{
    orbit::ElementSet elements;
    passes::Pass pass;
};

inline KeyholePass highestOf(UtcTime epoch, Angle node)
{
    KeyholePass best{.elements = fakes::lowOrbit(epoch, node), .pass = {}};
    best.elements.name = "ZENITH ONE";
    const passes::PassList list = passes::findPasses(
        orbit::Sgp4(best.elements), {.site = kKeyholeSite, .from = epoch, .to = epoch + std::chrono::hours(23)});
    for (const passes::Pass& pass : list.passes) {
        if (pass.tca.direction.elevation > best.pass.tca.direction.elevation && !pass.isUpAtStart) {
            best.pass = pass;
        }
    }
    return best;
}

// The highest pass of the next 23 hours for the best node: within a degree of the zenith.
inline KeyholePass keyholePass(UtcTime epoch)
{
    const auto better = [epoch](KeyholePass best, Angle from, Angle to, Angle step) {
        for (Angle node = from; node <= to; node += step) {
            const KeyholePass one = highestOf(epoch, node);
            best = one.pass.tca.direction.elevation > best.pass.tca.direction.elevation ? one : best;
        }
        return best;
    };
    const KeyholePass coarse = better({}, 0_deg, 24_deg, 1_deg);
    const Angle near = coarse.elements.ascendingNode;
    const KeyholePass fine = better(coarse, near - 1_deg, near + 1_deg, Angle::fromDegrees(0.05));
    EXPECT_GT(fine.pass.tca.direction.elevation, Angle::fromDegrees(89.0));
    return fine;
}

// 6°/s, with elevations over the top, and a beam of 5°.
inline profile::Profile keyholeProfile()
{
    profile::Profile profile;
    profile.mount.beamWidth = 5_deg;
    profile.site = {.known = true,
                    .latitude = kKeyholeSite.latitude,
                    .longitude = kKeyholeSite.longitude,
                    .heightMetres = kKeyholeSite.heightMetres};
    for (profile::AxisSettings* const axis : {&profile.azimuth, &profile.elevation}) {
        axis->limits.speed = AngularRate::fromDegrees(6.0);
        axis->limits.acceleration = AngularAcceleration::fromDegrees(6.0);
    }
    profile.azimuth.geometry.travel = {-90_deg, 450_deg};
    profile.elevation.geometry.travel = {0_deg, 180_deg};
    profile.limits.azimuth = {-90_deg, 450_deg};
    profile.limits.elevation = {0_deg, 180_deg};
    return profile;
}

inline PlanQuestion questionOf(const KeyholePass& keyhole, const profile::Profile& profile)
{
    return {.target = targets::satelliteTarget(keyhole.elements),
            .task = {.from = keyhole.pass.aos.utc, .to = keyhole.pass.los.utc, .now = profile.park, .bound = {}},
            .profile = std::make_shared<const profile::Profile>(profile),
            .antenna = profile.antenna({})};
}

}  // namespace boresight::ui
