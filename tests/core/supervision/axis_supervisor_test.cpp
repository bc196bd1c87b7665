// SPDX-License-Identifier: GPL-3.0-or-later
// Hand-made observations of cases that are hard to cause on a simulated mount.
#include "core/supervision/axis_supervisor.h"

#include "core/supervision/place_belief.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace boresight::supervision {
namespace {

using ::testing::HasSubstr;

class AxisSupervisorTest : public ::testing::Test
{
protected:
    AxisSupervisorTest() { seen.received = seen.now; }

    // One tick. An engaged axis moves at `rate` with its set-point.
    std::vector<Observed> tick(AngularRate rate = {}, Seconds period = Seconds(0.02))
    {
        seen.now += std::chrono::duration_cast<SteadyTime::duration>(period);
        seen.received = seen.now;
        seen.fresh = true;
        seen.actual += rate * period;
        seen.commanded += rate * period;
        seen.commandedRate = rate;
        last = supervisor.observe(believed());
        return last;
    }
    // The observation as DriveWatch makes it: `seen.actual` is the position that the drive reports.
    AxisObservation believed()
    {
        belief.take({.asked = seen.now, .received = seen.received, .place = turns(seen.actual)});
        AxisObservation result = seen;
        result.placed = belief.believedLast();
        result.actual = belief.place() ? Angle::fromTurns(belief.place()->position.turns()) : Angle{};
        if (const auto leap = belief.takeJump()) {
            result.jumped = AngleLeap{.by = Angle::fromTurns((leap->to - leap->from).turns()),
                                      .to = Angle::fromTurns(leap->to.turns()),
                                      .within = leap->within};
        }
        return result;
    }
    static MotorTurns turns(Angle angle) { return MotorTurns::fromTurns(angle.turns()); }
    void ticks(int count, AngularRate rate = {})
    {
        for (int i = 0; i < count; ++i) {
            tick(rate);
        }
    }
    [[nodiscard]] std::optional<Observed> found(Symptom symptom) const
    {
        const auto it = std::ranges::find(last, symptom, &Observed::symptom);
        return it != last.end() ? std::optional(*it) : std::nullopt;
    }
    [[nodiscard]] bool stops(Symptom symptom) const
    {
        const auto one = found(symptom);
        return one && one->weight == Weight::Stop;
    }

    profile::Profile profile;
    profile::InForce inForce{profile};
    AxisSupervisor supervisor{Axis::Azimuth, inForce};
    PlaceBelief belief{{.allowance = turns(0.5_deg), .speed = turns(10_deg) / Seconds(1.0)}};
    AxisObservation seen{.now = SteadyTime(std::chrono::hours(1)),
                         .actual = 100_deg,
                         .engaged = true,
                         .commanded = 100_deg,
                         .voltage = 24.0,
                         .boardTemperature = 30.0,
                         .turnKnown = true};
    std::vector<Observed> last;
};

// REQ-SUPERVISION-13
TEST_F(AxisSupervisorTest, ASetpointThatIsPutSomewhereElseIsNoMotion)
{
    ticks(50);
    seen.actual -= 2.5_deg;  // in small steps while the drive was silent
    seen.commanded = seen.actual;
    belief.forget();
    supervisor.forgetMotion();
    ticks(100);
    EXPECT_TRUE(last.empty());
    seen.commanded += 1.2_deg;  // in one step, and the axis follows
    for (int i = 0; i < 4; ++i) {
        seen.actual += 0.3_deg;
        tick();
    }
    ticks(100);
    EXPECT_TRUE(last.empty());
}

// A motor with exchanged phases gives full torque, too, and turns faster and faster.
TEST_F(AxisSupervisorTest, AnAxisThatGetsFasterAgainstItsCommandIsTheWrongWayWhateverItsDriveReports)
{
    ticks(50);
    seen.limit = QStringLiteral(" (limit 102 of the drive)");
    AngularRate rate;
    for (int i = 0; i < 20 && !stops(Symptom::WrongWay); ++i) {
        rate += 3_deg_s;
        seen.actual -= rate * Seconds(0.02) + 5_deg_s * Seconds(0.02);  // tick() moves it along with its set-point
        tick(5_deg_s);
    }
    EXPECT_TRUE(stops(Symptom::WrongWay));
    EXPECT_LT((100_deg - seen.actual).degrees(), 1.0);
}

// Story: without this the alarm that was just acknowledged followed at once after a re-arm.
// REQ-SUPERVISION-13: Supervision starts again after a re-arm and when a drive is engaged. A set-point that is put
// somewhere else is no motion.
TEST_F(AxisSupervisorTest, ReArmingForgetsWhatWasFoundInTheMotion)
{
    ticks(50);
    seen.actual += 4_deg;
    ticks(50);
    EXPECT_TRUE(stops(Symptom::EncoderJump));
    EXPECT_TRUE(stops(Symptom::FollowingError));
    EXPECT_FALSE(found(Symptom::MovesUncommanded)) << "the axis has not moved, its angle has";
    seen.commanded = seen.actual;
    supervisor.forgetMotion();
    tick();
    EXPECT_TRUE(last.empty());

    seen.actual += 4_deg;
    ticks(50);
    EXPECT_FALSE(last.empty());
    seen.engaged = false;
    ticks(1);
    seen.commanded = seen.actual;
    seen.engaged = true;
    tick();
    EXPECT_FALSE(found(Symptom::FollowingError)) << "engaging is a new beginning, too";
    EXPECT_TRUE(stops(Symptom::EncoderJump)) << "but not for an angle that jumped";
}

TEST_F(AxisSupervisorTest, StopsComeFirstAndEachKindOnce)
{
    seen.voltage = 19.0;
    ticks(50);
    seen.actual += 4_deg;
    ticks(50);
    ASSERT_GE(last.size(), 3U);
    EXPECT_TRUE(std::ranges::is_partitioned(last, [](const Observed& one) { return one.weight == Weight::Stop; }));
    for (const Observed& one : last) {
        EXPECT_EQ(std::ranges::count(last, one.symptom, &Observed::symptom), 1) << one.what.toStdString();
    }
    EXPECT_TRUE(found(Symptom::SupplyLow));
}

// REQ-SUPERVISION-05
TEST_F(AxisSupervisorTest, ALateReplyIsNoJumpOfTheEncoder)
{
    ticks(50, 10_deg_s);
    for (int i = 0; i < 5; ++i) {  // 0.1 s without a reply, then all missed replies at once
        seen.now += std::chrono::milliseconds(20);
        seen.fresh = false;
        seen.commanded += 10_deg_s * Seconds(0.02);
        last = supervisor.observe(seen);
    }
    seen.actual += 10_deg_s * Seconds(0.1);
    tick(10_deg_s);
    ticks(50, 10_deg_s);
    EXPECT_FALSE(found(Symptom::EncoderJump));
    EXPECT_FALSE(stops(Symptom::FollowingError));
}

// REQ-SUPERVISION-05
TEST_F(AxisSupervisorTest, ATurnThatIsSetIsNoJumpOfTheEncoder)
{
    seen.turnKnown = false;
    seen.engaged = false;
    ticks(100);
    seen.turnKnown = true;
    seen.actual += 36_deg;
    belief.expectAnother();
    ticks(100);
    EXPECT_TRUE(last.empty());
    seen.actual += 36_deg;  // a wrap that is corrected
    belief.expectAnother();
    supervisor.forgetMotion();
    ticks(100);
    EXPECT_TRUE(last.empty());
}

// Story: the power of a drive failed for a moment while the drive was enabled. It woke up on another turn, and the
// mount went there.
TEST_F(AxisSupervisorTest, AJumpWhileEnablingStops)
{
    seen.engaged = false;
    ticks(100);
    seen.engaging = true;
    ticks(2);
    seen.engaging = false;
    seen.engaged = true;
    seen.actual -= 180_deg;
    ticks(PlaceBelief::kJump);
    supervisor.forgetCommand();
    ASSERT_FALSE(last.empty());
    EXPECT_EQ(last.front().symptom, Symptom::EncoderJump);
    EXPECT_EQ(last.front().weight, Weight::Stop);
}

TEST_F(AxisSupervisorTest, NoiseOfADirectDriveIsNoMotion)
{
    for (int i = 0; i < 500; ++i) {
        seen.actual += (i % 2 == 0 ? 0.022_deg : -0.022_deg);  // one count of 16384, without a gearbox
        tick();
        ASSERT_TRUE(last.empty()) << i;
    }
}

// REQ-SUPERVISION-01
TEST_F(AxisSupervisorTest, AFastAxisMayBeTwoTicksBehind)
{
    profile.azimuth.limits.speed = 60_deg_s;
    belief.setLimits({.allowance = turns(0.5_deg), .speed = turns(60_deg) / Seconds(1.0)});
    inForce.apply(profile);
    seen.actual -= 60_deg_s * Seconds(0.05);
    supervisor.forgetMotion();
    seen.engaged = false;
    tick();
    seen.engaged = true;
    ticks(100, 60_deg_s);
    EXPECT_FALSE(found(Symptom::FollowingError));
}

TEST_F(AxisSupervisorTest, ATextIsRenewedWhenAnAxisWasTurnedTwiceAsFar)
{
    seen.engaged = false;
    ticks(100);
    for (int i = 0; i < 150; ++i) {
        seen.actual += 0.1_deg;
        tick();
    }
    ASSERT_TRUE(found(Symptom::MovesUncommanded));
    EXPECT_EQ(found(Symptom::MovesUncommanded)->weight, Weight::Hint);
    EXPECT_THAT(found(Symptom::MovesUncommanded)->what.toStdString(),
                ::testing::MatchesRegex("the azimuth moved by 1[0-5]\\.[0-9]°.*without a command .weight, wind.*"));
}

// REQ-SUPERVISION-08
TEST_F(AxisSupervisorTest, TheSupplyMustReturnByHalfAVoltAndStayThere)
{
    seen.voltage = 19.9;
    ticks(50);
    ASSERT_TRUE(found(Symptom::SupplyLow));
    seen.voltage = 20.4;
    ticks(200);
    EXPECT_TRUE(found(Symptom::SupplyLow));
    seen.voltage = 20.6;
    ticks(48);
    EXPECT_TRUE(found(Symptom::SupplyLow));
    ticks(4);
    EXPECT_FALSE(found(Symptom::SupplyLow));
}

// REQ-SUPERVISION-08
TEST_F(AxisSupervisorTest, AnEmptySupplyOfADriveThatIsOffIsAHint)
{
    seen.engaged = false;
    seen.voltage = 8.0;
    ticks(50);
    ASSERT_TRUE(found(Symptom::SupplyLow));
    EXPECT_FALSE(stops(Symptom::SupplyLow));
}

// REQ-SUPERVISION-09
TEST_F(AxisSupervisorTest, BoardAndMotorAreHot)
{
    seen.boardTemperature = 61.0;
    seen.motorTemperature = 82.0;
    ticks(2);
    EXPECT_EQ(found(Symptom::BoardHot)->what.toStdString(),
              "the drive board of the azimuth reached 61 °C and switches off at 75 °C");
    EXPECT_EQ(found(Symptom::MotorHot)->what.toStdString(), "the motor of the azimuth reached 82 °C");
    EXPECT_FALSE(stops(Symptom::BoardHot));
}

// REQ-SUPERVISION-09
TEST_F(AxisSupervisorTest, AMotorThatWarmsUpIsToldWithTheTimeLeft)
{
    for (int i = 0; i < 45 * 50; ++i) {
        seen.motorTemperature = 54.0 + 6.0 * i / (60.0 * 50.0);
        tick();
    }
    ASSERT_TRUE(found(Symptom::MotorHot));
    EXPECT_THAT(
        found(Symptom::MotorHot)->what.toStdString(),
        HasSubstr("the motor of the azimuth reached 58 °C. It rises by 6.0 °C/min and will reach 80 °C at 00:0"));
}

// REQ-SUPERVISION-09
TEST_F(AxisSupervisorTest, AMotorThatCoolsDownIsNotTold)
{
    for (int i = 0; i < 60 * 50; ++i) {
        seen.motorTemperature = 79.0 - 6.0 * i / (60.0 * 50.0);
        tick();
        ASSERT_FALSE(found(Symptom::MotorHot)) << i;
    }
}

// REQ-SUPERVISION-06
TEST_F(AxisSupervisorTest, WithoutTheTurnTheTravelIsNotJudged)
{
    seen.turnKnown = false;
    seen.actual = 470_deg;
    seen.commanded = seen.actual;
    ticks(100);
    EXPECT_TRUE(last.empty());
    seen.turnKnown = true;
    ticks(2);
    EXPECT_TRUE(found(Symptom::OutsideTravel));
}

TEST_F(AxisSupervisorTest, AJumpOutOfTheTravelIsNoMotionOutwards)
{
    ticks(50);
    seen.actual = 460_deg;
    ticks(PlaceBelief::kJump + 1);
    EXPECT_TRUE(stops(Symptom::EncoderJump));
    ASSERT_TRUE(found(Symptom::OutsideTravel));
    EXPECT_FALSE(stops(Symptom::OutsideTravel));
}

class AtTickRate : public AxisSupervisorTest, public ::testing::WithParamInterface<int>
{};

// REQ-SUPERVISION-02 (AtTickRate.*)
TEST_P(AtTickRate, AStallIsFoundInTheSameTime)
{
    const Seconds period(1.0 / GetParam());
    for (int i = 0; i < GetParam(); ++i) {
        tick(5_deg_s, period);
    }
    ASSERT_TRUE(last.empty());
    const Angle stuck = seen.actual;
    const SteadyTime since = seen.now;
    while (!stops(Symptom::Stalled) && seen.now - since < Seconds(2.0)) {
        tick(5_deg_s, period);
        seen.actual = stuck;
    }
    EXPECT_LE(seen.now - since, Seconds(1.0));
    EXPECT_GE(seen.now - since, Seconds(0.7));
}

INSTANTIATE_TEST_SUITE_P(Hz, AtTickRate, ::testing::Values(20, 50, 200));

}  // namespace
}  // namespace boresight::supervision
