// SPDX-License-Identifier: GPL-3.0-or-later
// The station drives a whole pass by its plan: over the top, with an unwrap, or as the operator chose.
#include "core/alarms/catalogue.h"
#include "tests/core/control/plan/pass_rig.h"

namespace boresight {
namespace {

using plan::PlanWay;

profile::Profile overTheTopMount()
{
    profile::Profile profile = passMount();
    profile.elevation.geometry.travel.max = 180_deg;
    return profile;
}

// The cable ends in the south, so a pass across the south fits on no wrap.
profile::Profile singleTurnMount()
{
    profile::Profile profile = passMount();
    profile.azimuth.geometry.travel = {.min = -180_deg, .max = 180_deg};
    return profile;
}

bool crossesTheSouth(const passes::Pass& pass)
{
    const Angle from = pass.aos.direction.azimuth.wrapped360();
    const Angle at = pass.tca.direction.azimuth.wrapped360();
    const Angle to = pass.los.direction.azimuth.wrapped360();
    const bool isSouth =
        100_deg < at && at < 260_deg && (from < 150_deg) == (to > 210_deg) && (from > 210_deg) == (to < 150_deg);
    return isSouth && 20_deg < pass.tca.direction.elevation && pass.tca.direction.elevation < 80_deg;
}

bool isHigh(const passes::Pass& pass)
{
    return pass.tca.direction.elevation > 86_deg && pass.tca.direction.elevation < 89.5_deg;
}

}  // namespace

// REQ-TRACK-1821: A mount whose limits permit elevations above 90° goes over the top during a pass where the error is
// then smaller. The status has the plan before the pass begins.
TEST(StationPlan, GoesOverTheTopWhereThisIsBetter)
{
    PassRig at(overTheTopMount());
    const fakes::FoundOrbit found = at.passWith(isHigh);
    const plan::PassPlan plan = at.planOf(found);
    ASSERT_EQ(plan.best().way, PlanWay::ThroughTheZenith);
    ASSERT_TRUE(at.track(found));
    at.awaitPlan();
    EXPECT_TRUE(at.logged("over the top there: off by up to "));
    ASSERT_TRUE(at.rig.control.status().tracked->plan);
    EXPECT_EQ(at.rig.control.status().tracked->plan->way, PlanWay::ThroughTheZenith);
    at.runUntil(found.pass.aos.utc);
    const PassRig::Run run = at.follow(found);
    EXPECT_LT(run.peak.degrees(), 1.05 * plan.best().forecast.peak.degrees() + 0.1);
    EXPECT_LT(run.lowest, 10_deg);
    EXPECT_GT(run.highest, 170_deg);
    EXPECT_FALSE(at.rig.control.faultLatched());
    RecordProperty("peak_deg", std::to_string(run.peak.degrees()));
    RecordProperty("planned_deg", std::to_string(plan.best().forecast.peak.degrees()));
}

// REQ-TRACK-1822: If no wrap of the cable has room for a pass, the mount unwraps at the moment of the plan. An advisory
// names the time before the pass begins, and goes after the pass. The time lost is that of the plan.
TEST(StationPlan, UnwrapsAtTheBestMoment)
{
    PassRig at(singleTurnMount());
    const fakes::FoundOrbit found = at.passWith(crossesTheSouth);
    const plan::PassPlan plan = at.planOf(found);
    ASSERT_EQ(plan.best().way, PlanWay::Unwraps);
    ASSERT_TRUE(at.track(found));
    at.awaitPlan();
    ASSERT_LT(at.rig.clock.utc(), found.pass.aos.utc);
    EXPECT_TRUE(at.rig.alarms.active(alarmEntry("track.split-pass")));
    at.runUntil(found.pass.aos.utc + std::chrono::seconds(1));
    const PassRig::Run run = at.follow(found);
    const Seconds planned = plan.best().unwrap->to - plan.best().unwrap->from;
    EXPECT_LT(run.lost.count(), planned.count() + 5.0);
    EXPECT_GT(run.lost.count(), 20.0) << "the cable was unwrapped";
    EXPECT_FALSE(at.logged("reaches its cable end"));
    at.runUntil(found.pass.los.utc + std::chrono::seconds(2));
    EXPECT_FALSE(at.rig.alarms.active(alarmEntry("track.split-pass")));
    EXPECT_FALSE(at.rig.control.faultLatched());
    RecordProperty("lost_s", std::to_string(run.lost.count()));
    RecordProperty("planned_s", std::to_string(planned.count()));
}

// REQ-TRACK-1823: The operator can choose another way through the pass.
TEST(StationPlan, DrivesTheChosenWay)
{
    PassRig at(singleTurnMount());
    const fakes::FoundOrbit found = at.passWith(crossesTheSouth);
    const plan::PassPlan plan = at.planOf(found);
    const auto waits = std::ranges::find(plan.variants, PlanWay::WaitsAtTheEnd, &plan::PlanVariant::way);
    ASSERT_NE(waits, plan.variants.end());
    ASSERT_TRUE(at.track(found, plan::choiceFor(*waits)));
    at.awaitPlan();
    EXPECT_EQ(at.rig.control.status().tracked->plan->way, PlanWay::WaitsAtTheEnd);
    EXPECT_NEAR(at.rig.control.status().tracked->plan->start().azimuth.degrees(), waits->start().azimuth.degrees(),
                0.1);
    at.runUntil(found.pass.aos.utc);
    const double start = at.rig.azimuthDegrees();
    const double end = waits->end().azimuth.degrees();
    at.rig.onTick = [&] {
        EXPECT_GT(at.rig.azimuthDegrees(), std::min(start, end) - 1.0) << "it does not turn back";
        EXPECT_LT(at.rig.azimuthDegrees(), std::max(start, end) + 1.0);
    };
    (void)at.follow(found, found.pass.tca.utc + (found.pass.los.utc - found.pass.tca.utc) / 2);
    const SkyPointing target = fakes::directionOf(found, kPassSite, at.rig.clock.utc());
    EXPECT_LT(angleBetween(at.rig.control.status().target.value(), target), 0.1_deg) << "the status has the target";
    (void)at.follow(found);
    EXPECT_NEAR(at.rig.azimuthDegrees(), end, 0.5);
    at.rig.onTick = nullptr;
}

// REQ-TRACK-1827: The side of the zenith is that of the beam. So a mount whose elevation axis shows more than the beam
// has does not turn round where the axis, but not the beam, is above 90°.
TEST(StationPlan, TheSideIsThatOfTheBeam)
{
    profile::Profile profile = overTheTopMount();
    profile.azimuth.limits.speed = 30_deg_s;
    profile.azimuth.limits.acceleration = 60_deg_s2;
    profile.pointing.elevationOffset = -4_deg;
    PassRig at(profile);
    const fakes::FoundOrbit found = at.passWith([](const passes::Pass& pass) {
        return pass.tca.direction.elevation > 87_deg && pass.tca.direction.elevation < 88.5_deg;
    });
    ASSERT_TRUE(at.track(found));
    at.awaitPlan();
    at.runUntil(found.pass.aos.utc + std::chrono::seconds(20));
    const PassRig::Run run = at.follow(found, found.pass.los.utc - std::chrono::seconds(20));
    EXPECT_GT(run.highest, 90_deg) << "the axis";
    EXPECT_LT(run.peak, 0.5_deg);
}

// REQ-TRACK-1825: A change of speeds or limits during a pass plans the rest of it again. The mount stays on its side of
// the zenith, because a change would lose time.
TEST(StationPlan, StaysOnItsSideWhenItIsPlannedAgain)
{
    PassRig at(overTheTopMount());
    const fakes::FoundOrbit found = at.passWith(isHigh);
    ASSERT_TRUE(at.track(found));
    at.awaitPlan();
    at.runUntil(found.pass.tca.utc + std::chrono::seconds(60));  // from here on both sides are equally good
    profile::Profile faster = at.rig.profile;
    faster.azimuth.limits.speed = 8_deg_s;
    at.rig.setProfile(faster);
    const PassRig::Run run = at.follow(found, at.rig.clock.utc() + std::chrono::seconds(1));
    at.awaitPlan();
    const PassRig::Run rest = at.follow(found);
    EXPECT_LT(std::max(run.peak, rest.peak), 0.5_deg);
    const bool wasOver = run.lowest > 90_deg;
    EXPECT_EQ(rest.lowest > 90_deg, wasOver);
    EXPECT_EQ(rest.highest > 90_deg, wasOver);
}

}  // namespace boresight
