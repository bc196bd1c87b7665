// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/night/tracked_pass.h"

#include "core/targets/target_path.h"
#include "tests/fakes/low_orbit.h"

#include <gtest/gtest.h>

namespace boresight {
namespace {

const Site kLisbon{.latitude = 38.757_deg, .longitude = -9.117_deg, .heightMetres = 80.0};
const UtcTime kDay = std::chrono::sys_days(std::chrono::year(2026) / 12 / 24);

// The largest error in the first minute of a pass. The beam uses one refraction rule, and the judgement another.
Angle peakError(ephemeris::RefractionRule beam, ephemeris::RefractionRule judged)
{
    const orbit::ElementSet elements = fakes::lowOrbit(kDay);
    targets::TargetPath path(targets::satelliteTarget(elements), kLisbon, beam);
    const targets::UpTime up = path.nextUp(kDay).value();
    schedule::WatchedPass pass{.number = elements.number, .pass = {}};
    pass.pass.aos.utc = up.rises;
    pass.pass.los.utc = up.sets.value();
    pass.pass.clear = {{.from = up.rises, .to = up.sets.value()}};
    TrackedPass tracked(pass, elements, kLisbon, {});
    for (std::chrono::seconds after{0}; after < std::chrono::minutes(1); ++after) {
        tracked.look({.direction = path.at(up.rises + after).value()}, up.rises + after, SteadyTime(after),
                     {.beamWidth = 10_deg, .refraction = judged});
    }
    return tracked.tally().record().peakError.value();
}

// Refraction by Sæmundsson: 29.0′ at the horizon.
// REQ-SCHEDULE-960: The report compares the beam with the satellite by the refraction rule of the profile.
TEST(TrackedPass, IsJudgedByTheRuleForRefraction)
{
    using ephemeris::RefractionRule;
    EXPECT_LT(peakError(RefractionRule::ByKind, RefractionRule::ByKind), 1e-6_deg);
    EXPECT_LT(peakError(RefractionRule::Light, RefractionRule::Light), 1e-6_deg);
    EXPECT_NEAR(peakError(RefractionRule::Light, RefractionRule::None).degrees() * 60.0, 29.0, 1.0);
}

}  // namespace
}  // namespace boresight
