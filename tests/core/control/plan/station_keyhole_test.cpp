// SPDX-License-Identifier: GPL-3.0-or-later
// The station tracks a satellite through the keyhole, where the azimuth is too slow for it.
#include "tests/core/control/plan/pass_rig.h"

namespace boresight {

// REQ-TRACK-997: A satellite that passes near the zenith faster than the azimuth turns is tracked by a plan: the mount
// leaves it early and returns late. The peak error is at most 5 % and 0.1° above the least one for these speeds. The
// log has the error to expect before the pass begins.
TEST(StationKeyhole, IsPassedWithTheLeastError)
{
    PassRig at(passMount());
    const fakes::FoundOrbit found =
        at.passWith([](const passes::Pass& pass) { return pass.tca.direction.elevation > 88_deg; });
    ASSERT_TRUE(at.track(found));
    at.awaitPlan();
    EXPECT_TRUE(at.logged("near the zenith, where the azimuth is too slow: off by up to "));
    ASSERT_LT(at.rig.clock.utc(), found.pass.aos.utc) << "before the pass";
    const Angle least = at.planOf(found).best().forecast.peak;
    EXPECT_GT(least, 1_deg) << "a keyhole";
    at.runUntil(found.pass.aos.utc + std::chrono::seconds(10));
    const PassRig::Run run = at.follow(found);
    EXPECT_LT(run.peak.degrees(), 1.05 * least.degrees() + 0.1);
    EXPECT_LT(std::chrono::abs(run.worst - found.pass.tca.utc), std::chrono::seconds(30));
    EXPECT_FALSE(at.rig.control.faultLatched());
    EXPECT_FALSE(at.logged("Reaches its cable end")) << "the cable has room for the way of the plan";
    RecordProperty("peak_deg", std::to_string(run.peak.degrees()));
    RecordProperty("least_deg", std::to_string(least.degrees()));
    RecordProperty("max_el_deg", std::to_string(found.pass.tca.direction.elevation.degrees()));
}

}  // namespace boresight
