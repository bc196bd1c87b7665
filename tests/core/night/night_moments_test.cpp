// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the messages to hooks, MQTT and the log during a night.
#include "tests/core/night/night_desk_fixture.h"

#include <gmock/gmock.h>

#include <array>

namespace boresight {
namespace {

using schedule::Moment;
using testing::ElementsAre;
using testing::SizeIs;

// REQ-HOOKS-10: Each moment of a pass is reported once, in order: before AOS, at AOS, at LOS. Each is a line in the
// log. While the schedule is not armed nothing is reported.
TEST_F(NightDeskTest, TheMomentsOfAPassAreTold)
{
    const schedule::WatchedPass pass = first();
    skipTo(pass.begins() - std::chrono::seconds(80));
    run(Seconds(1.0));
    EXPECT_THAT(told, SizeIs(0));
    ASSERT_EQ(arm(), "");
    runUntil(pass.begins() + std::chrono::seconds(2));
    skipTo(pass.ends() - std::chrono::seconds(5));
    runUntil(pass.ends() + std::chrono::seconds(5));
    ASSERT_THAT(moments(), ElementsAre(Moment::BeforeAos, Moment::Aos, Moment::Los));
    const std::array<UtcTime, 3> due{pass.begins() - std::chrono::seconds(60), pass.begins(), pass.ends()};
    for (std::size_t i = 0; i < due.size(); ++i) {
        EXPECT_NEAR(Seconds(told[i].utc - due[i]).count(), 0.0, 0.1);
        EXPECT_EQ(told[i].pass, pass);
    }
    EXPECT_EQ(told[2].end, schedule::PassEnd::Set);
    EXPECT_TRUE(logged("the pass of SAT 90001 begins at"));
    EXPECT_TRUE(logged("AOS of SAT 90001"));
    EXPECT_TRUE(logged("LOS of SAT 90001"));
}

// REQ-HOOKS-11: If the beginning of a pass was reported, its end is reported too, whatever ends it. If the schedule is
// armed in the middle of a pass, the past moments are reported at once.
TEST_F(NightDeskTest, WhatWasToldToComeIsToldToEnd)
{
    ASSERT_EQ(arm(), "");
    skipTo(first().begins() - std::chrono::seconds(30));
    run(Seconds(1.0));
    operatorAsks(request::Hold{});
    ASSERT_THAT(moments(), ElementsAre(Moment::BeforeAos, Moment::Los));
    EXPECT_EQ(told[1].end, schedule::PassEnd::Manual);
    EXPECT_EQ(told[1].why, QStringLiteral("operator sent another command"));
    EXPECT_TRUE(logged("the pass of SAT 90001 ends before its LOS"));
    told.clear();
    skipTo(first().begins() + std::chrono::seconds(20));
    ASSERT_EQ(arm(), "");
    run(Seconds(1.0));
    EXPECT_THAT(moments(), ElementsAre(Moment::BeforeAos, Moment::Aos));
    EXPECT_EQ(answer(request::DisarmSchedule{}), "");
    EXPECT_THAT(moments(), ElementsAre(Moment::BeforeAos, Moment::Aos, Moment::Los));
    told.clear();
    run(Seconds(5.0));
    EXPECT_THAT(told, SizeIs(0));
}

// REQ-HOOKS-11
TEST_F(NightDeskTest, APassThatIsNotPlannedAnyMoreIsToldToEnd)
{
    profile::Profile early = rig.profile;
    early.schedule.hooks.before = Seconds(300.0);
    rig.setProfile(early);
    ASSERT_EQ(arm(), "");
    skipTo(first().begins() - std::chrono::seconds(200));
    run(Seconds(1.0));
    ASSERT_THAT(moments(), ElementsAre(Moment::BeforeAos));
    desk.setSatellites(std::make_shared<const std::vector<orbit::ElementSet>>());
    run(Seconds(1.0));
    ASSERT_THAT(moments(), ElementsAre(Moment::BeforeAos, Moment::Los));
    EXPECT_EQ(told[1].end, schedule::PassEnd::Refused);
}

// REQ-HOOKS-12: A fault that ends the armed schedule is reported, with the pass if there is one. Then the end of this
// pass is reported. Without an armed schedule a fault is not reported.
TEST_F(NightDeskTest, AFaultIsTold)
{
    intoAPass();
    rig.azimuth.mode = moteus::Mode::Fault;
    rig.azimuth.fault = 33;
    run(Seconds(1.0));
    ASSERT_THAT(moments(), ElementsAre(Moment::BeforeAos, Moment::Aos, Moment::Fault, Moment::Los));
    EXPECT_EQ(told[2].pass, told[1].pass);
    EXPECT_EQ(told[2].why, QStringLiteral("a fault ended the motion"));
    EXPECT_EQ(told[3].end, schedule::PassEnd::Fault);
    rig.elevation.mode = moteus::Mode::Fault;
    rig.elevation.fault = 33;
    run(Seconds(1.0));
    EXPECT_THAT(told, SizeIs(4)) << "it is not armed any more";
}

}  // namespace
}  // namespace boresight
