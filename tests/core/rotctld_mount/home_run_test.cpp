// SPDX-License-Identifier: GPL-3.0-or-later
// A rotator without encoders that has lost steps, and its home run.
#include "core/rotator_box/home_run.h"

#include "tests/core/rotctld_mount/rotctld_bench.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace boresight::rotctl {
namespace {

// A rotator that counts 12° and 3° more than the truth.
class RotctldHomeRun : public testing::Test
{
protected:
    RotctldHomeRun()
    {
        bench.box().faults().lost = {.azimuth = 12_deg, .elevation = 3_deg};
        bench.run(Seconds(5.0));
    }
    void expectShown(Angle azimuth, Angle elevation)
    {
        const auto measured = bench.control().mount().measured();
        ASSERT_TRUE(measured);
        EXPECT_NEAR(measured->azimuth.degrees(), azimuth.degrees(), 0.2);
        EXPECT_NEAR(measured->elevation.degrees(), elevation.degrees(), 0.2);
    }
    [[nodiscard]] long count(const char* line) { return std::ranges::count(bench.box().heard(), std::string(line)); }

    RotctldBench bench;
};

// REQ-ROTCTLDMOUNT-74: A home run is the command `\reset 1` of rotctld. Boresight lets the rotator go, watches it, and
// takes it over again when it has stood still. The count then agrees with the truth, and a jump of the count is no
// fault. An alarm shows the run.
TEST_F(RotctldHomeRun, TheCountAgreesWithTheTruthAgain)
{
    ASSERT_TRUE(bench.goTo(60.0, 30.0));
    bench.run(Seconds(30.0));
    expectShown(60_deg, 30_deg);
    EXPECT_NEAR(bench.truth().azimuth.degrees(), 48.0, 0.2);
    ASSERT_TRUE(bench.control().status().capabilities.makesHomeRuns);
    ASSERT_TRUE(bench.control().status().permissions.allows(Action::MakeHomeRun));
    ASSERT_TRUE(bench.ask(request::MakeHomeRun{}));
    bench.mount().home();
    bench.run(Seconds(2.0));
    EXPECT_EQ(bench.box().homeRuns(), 1);
    EXPECT_TRUE(bench.isActive("rotator.home-run"));
    EXPECT_FALSE(bench.control().status().permissions.allows(Action::MakeHomeRun)) << "it is under way";
    const int ordered = bench.box().moves();
    bench.run(Seconds(30.0));
    EXPECT_EQ(bench.box().moves(), ordered) << "nothing is sent meanwhile";
    EXPECT_FALSE(bench.isActive("rotator.home-run"));
    EXPECT_NE(bench.control().state(), StationState::Fault);
    expectShown(0_deg, 0_deg);
    EXPECT_NEAR(bench.truth().azimuth.degrees(), 0.0, 0.2);
    ASSERT_TRUE(bench.goTo(60.0, 30.0));
    bench.run(Seconds(30.0));
    EXPECT_NEAR(bench.truth().azimuth.degrees(), 60.0, 0.3);
    EXPECT_NEAR(bench.truth().elevation.degrees(), 30.0, 0.3);
}

// REQ-ROTCTLDMOUNT-75: A rotator that refuses the command, because Hamlib has none for it, raises an alarm with the
// reason. Nothing moves, and the next motion works.
TEST_F(RotctldHomeRun, ARefusalIsToldAndNothingMoves)
{
    bench.box().faults().reset = ErrorCode::NotAvailable;
    bench.mount().home();
    bench.run(Seconds(5.0));
    EXPECT_TRUE(bench.isActive("rotator.no-home-run"));
    EXPECT_FALSE(bench.isActive("rotator.home-run"));
    EXPECT_TRUE(bench.stands(Seconds(2.0)));
    ASSERT_TRUE(bench.goTo(30.0, 30.0));
    bench.run(Seconds(20.0));
    expectShown(30_deg, 30_deg);
}

// REQ-ROTCTLDMOUNT-76: STOP ends a home run.
TEST_F(RotctldHomeRun, StopEndsIt)
{
    ASSERT_TRUE(bench.goTo(200.0, 60.0));
    bench.run(Seconds(60.0));
    bench.mount().home();
    bench.run(Seconds(3.0));
    ASSERT_FALSE(bench.stands(Seconds(0.5)));
    ASSERT_TRUE(bench.ask(request::Stop{}));
    bench.run(Seconds(2.0));
    EXPECT_TRUE(bench.stands(Seconds(5.0)));
    EXPECT_FALSE(bench.isActive("rotator.home-run"));
    EXPECT_GT(bench.truth().azimuth, 100_deg);
    EXPECT_FALSE(bench.ask(request::MakeHomeRun{})) << "STOP is latched";
}

// REQ-ROTCTLDMOUNT-77: Only the operator starts a home run, while the mount stands and tracks nothing. A mount with
// brakes is refused, because the rotator does not wait for them.
TEST_F(RotctldHomeRun, IsRefusedWhereItMustNotBegin)
{
    EXPECT_FALSE(bench.control().request(request::MakeHomeRun{}, kClient));
    ASSERT_TRUE(bench.goTo(100.0, 30.0));
    bench.run(Seconds(3.0));
    EXPECT_FALSE(bench.ask(request::MakeHomeRun{})) << "it moves";
    bench.run(Seconds(40.0));
    EXPECT_TRUE(bench.control().status().permissions.allows(Action::MakeHomeRun));
    profile::Profile braked = *bench.inForce();
    braked.brake.output = "rts:/dev/ttyUSB0";
    bench.edit(braked);
    bench.run(Seconds(1.0));
    const auto refused = bench.ask(request::MakeHomeRun{});
    ASSERT_FALSE(refused);
    EXPECT_TRUE(refused.error().text.contains(QStringLiteral("brakes")));
}

// REQ-ROTCTLDMOUNT-78: A home run ends when the rotator has accepted it and then stood for 5 s. After 10 minutes
// without a standstill it is stopped, with an alarm.
TEST_F(RotctldHomeRun, EndsByTheStandstill)
{
    bench.box().faults().lost = {.azimuth = 400_deg, .elevation = 3_deg};
    bench.box().faults().pace = {0.05, 0.05};  // 0.3 °/s
    bench.mount().home();
    bench.run(Seconds(8.0));
    EXPECT_TRUE(bench.isActive("rotator.home-run")) << "it moves";
    bench.run(Seconds(588.0));
    EXPECT_TRUE(bench.isActive("rotator.home-run"));
    bench.run(Seconds(10.0));
    EXPECT_FALSE(bench.isActive("rotator.home-run"));
    EXPECT_TRUE(bench.isActive("rotator.no-home-run"));
    bench.run(Seconds(3.0));
    EXPECT_TRUE(bench.stands(Seconds(5.0)));
}

}  // namespace
}  // namespace boresight::rotctl
