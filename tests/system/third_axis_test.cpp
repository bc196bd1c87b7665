// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/system/simulated_station.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

// The axis beside the two: from the request of the window to the physics of its drive.
namespace boresight::system_test {
namespace {

using ::testing::HasSubstr;
using State = ThirdAxisStatus::State;

constexpr int kThirdId = 3;
constexpr AngularRate kRate = AngularRate::fromDegrees(5.0);

profile::Profile withThirdAxis()
{
    profile::Profile profile = anyPort();
    profile.thirdAxis.axis.id = kThirdId;
    profile.thirdAxis.axis.geometry.travel = {.min = -20_deg, .max = 20_deg};
    return profile;
}

sim::PairSettings withThirdBoard()
{
    sim::PairSettings pair = sim::commissionedPair();
    pair.third = sim::commissionedFeed(kThirdId);
    return pair;
}

class ThirdAxisTest : public ::testing::Test
{
protected:
    explicit ThirdAxisTest(const profile::Profile& profile = withThirdAxis(),
                           const sim::PairSettings& pair = withThirdBoard())
        : rig(profile, pair)
    {}

    [[nodiscard]] double truth() { return 360.0 * rig.link->pair().third().plant().position(); }
    [[nodiscard]] double speed() { return 360.0 * rig.link->pair().third().plant().velocity(); }
    [[nodiscard]] moteus::Mode mode() { return rig.link->pair().third().servo().mode(); }
    [[nodiscard]] ThirdAxisStatus third() const { return rig.status().thirdAxis.value_or(ThirdAxisStatus{}); }
    [[nodiscard]] QString whyNot(Action action) const { return rig.status().permissions.reason(action); }
    std::string jog(AngularRate rate) { return rig.ask(request::JogThirdAxis{.rate = rate}); }
    // The button is held: the request is repeated as the window repeats it. Returns the last answer.
    std::string hold(AngularRate rate, Seconds time)
    {
        std::string answer;
        for (Seconds left = time; left > Seconds(0.0); left -= Seconds(0.06)) {
            answer = jog(rate);
            rig.run(Seconds(0.06));
        }
        return answer;
    }

    SimulatedStation rig;
};

class NoThirdAxis : public ThirdAxisTest
{
protected:
    NoThirdAxis() : ThirdAxisTest(anyPort()) {}
};

// REQ-THIRD-10: A further board on the bus is an axis beside the two only if the profile names it (third_axis.id).
// Otherwise Boresight shows and moves nothing of it.
TEST_F(NoThirdAxis, IsOffUnlessTheProfileNamesIt)
{
    EXPECT_FALSE(rig.status().thirdAxis.has_value());
    EXPECT_THAT(jog(kRate), HasSubstr("third_axis.id"));
    EXPECT_THAT(whyNot(Action::JogThirdAxisUp).toStdString(), HasSubstr("This mount has no third axis."));
    rig.run(Seconds(0.5));
    EXPECT_EQ(mode(), moteus::Mode::Stopped);
}

// REQ-THIRD-11: The status has the name, the angle, the mode, the fault and the temperature of the third axis. Watching
// it commands nothing.
TEST_F(ThirdAxisTest, IsWatchedWithoutBeingCommanded)
{
    rig.run(Seconds(5.0));
    const ThirdAxisStatus axis = third();
    EXPECT_EQ(axis.name, QStringLiteral("polarisation"));
    EXPECT_EQ(axis.state, State::Off);
    EXPECT_NEAR(axis.place.value().degrees(), truth(), 0.05);
    EXPECT_EQ(axis.mode, QStringLiteral("stopped (0)"));
    EXPECT_TRUE(axis.boardTemperature.has_value());
    EXPECT_TRUE(axis.fault.isEmpty());
    EXPECT_LT(axis.age.value(), std::chrono::milliseconds(100));
    EXPECT_EQ(mode(), moteus::Mode::Stopped);
    EXPECT_TRUE(rig.status().drives->unknownBoards.empty());
}

// REQ-THIRD-12: The operator jogs the third axis while a button is held, at no more than its own speed. On release it
// slows down and is held. The mount does not move.
TEST_F(ThirdAxisTest, MovesWhileTheButtonIsHeld)
{
    const AxisPosition mount = rig.truth();
    EXPECT_EQ(hold(kRate, Seconds(1.2)), "");
    EXPECT_NEAR(speed(), 5.0, 0.5);
    EXPECT_EQ(third().state, State::Moving);
    EXPECT_EQ(jog({}), "");
    const double released = truth();
    rig.run(Seconds(1.5));
    EXPECT_NEAR(speed(), 0.0, 0.05);
    EXPECT_LT(truth() - released, 3.0);
    EXPECT_EQ(mode(), moteus::Mode::Position);
    EXPECT_EQ(third().state, State::Holding);
    EXPECT_LT(rig.farthestFrom(mount).degrees(), 0.05);
    EXPECT_EQ(rig.status().state, StationState::Standby);
    EXPECT_THAT(jog(kRate + kRate), HasSubstr("above the limit of the third axis (5.0°/s)"));
}

// REQ-THIRD-13: A jog of the third axis ends at its own travel. There only the way back is offered.
TEST_F(ThirdAxisTest, StaysWithinItsTravel)
{
    EXPECT_THAT(hold(kRate, Seconds(8.0)), HasSubstr("at the end of its travel (20.0°)"));
    EXPECT_NEAR(truth(), 20.0, 0.1);
    EXPECT_FALSE(whyNot(Action::JogThirdAxisUp).isEmpty());
    EXPECT_TRUE(whyNot(Action::JogThirdAxisDown).isEmpty());
    jog({});
    EXPECT_EQ(hold(-kRate, Seconds(0.6)), "");
    EXPECT_LT(truth(), 19.5);
}

// REQ-THIRD-14: The jog ends 0.2 s after the last keep-alive. A client cannot jog the third axis.
TEST_F(ThirdAxisTest, EndsWithoutItsKeepAlive)
{
    EXPECT_EQ(hold(kRate, Seconds(1.0)), "");
    const double then = truth();
    rig.run(Seconds(2.0));
    EXPECT_NEAR(speed(), 0.0, 0.05);
    EXPECT_LT(truth() - then, 5.0 * 0.25 + 2.5);
    EXPECT_THAT(jog(kRate), HasSubstr("Release the button")) << "a window that stalled does not move it again";
    EXPECT_TRUE(rig.logSays(QStringLiteral("keep-alive")));
}

// REQ-THIRD-15: STOP stops the third axis as hard as it can, and refuses its jog. After the reset nothing moves before
// the button is released and pressed again.
TEST_F(ThirdAxisTest, StopsAtSTOP)
{
    EXPECT_EQ(hold(kRate, Seconds(1.2)), "");
    ASSERT_EQ(rig.ask(request::Stop{}), "");
    const double then = truth();
    EXPECT_THAT(hold(kRate, Seconds(0.6)), HasSubstr("STOP is latched"));
    EXPECT_NEAR(speed(), 0.0, 0.05);
    EXPECT_LT(truth() - then, 1.0);
    rig.run(Seconds(1.0));
    EXPECT_THAT(hold(kRate, Seconds(0.3)), HasSubstr("STOP is latched"));
    ASSERT_EQ(rig.ask(request::ResetStop{}), "");
    const double reset = truth();
    EXPECT_THAT(hold(kRate, Seconds(1.0)), HasSubstr("Release the button"));
    EXPECT_NEAR(truth(), reset, 0.05);
    EXPECT_EQ(jog({}), "");
    EXPECT_EQ(hold(kRate, Seconds(0.6)), "");
    EXPECT_GT(truth(), reset + 0.5);
}

// REQ-THIRD-16: If Boresight dies, the watchdog of the drive stops the third axis.
TEST_F(ThirdAxisTest, IsStoppedByItsOwnWatchdog)
{
    EXPECT_EQ(hold(kRate, Seconds(1.2)), "");
    const double then = truth();
    rig.clock.advance(Seconds(0.4));  // no tick and no frame
    EXPECT_NEAR(speed(), 0.0, 0.1);
    EXPECT_EQ(mode(), moteus::Mode::PositionTimeout);
    EXPECT_LT(truth() - then, 5.0 * 0.1 + 0.5);
    rig.run(Seconds(1.0));
    EXPECT_NEAR(speed(), 0.0, 0.1) << "nothing starts by itself";
    jog({});
    EXPECT_EQ(hold(kRate, Seconds(1.5)), "");
    EXPECT_GT(speed(), 3.0) << "an explicit act takes the axis over again";
}

// REQ-THIRD-17: A drive that falls silent or loses its power ends the jog and raises an alarm. When it is back, nothing
// moves before the button is released and pressed again.
TEST_F(ThirdAxisTest, DoesNotMoveByItselfAfterASilence)
{
    EXPECT_EQ(hold(kRate, Seconds(1.0)), "");
    rig.link->pair().third().setPowered(false);
    EXPECT_NE(hold(kRate, Seconds(2.6)), "");
    EXPECT_EQ(third().state, State::NoData);
    EXPECT_TRUE(rig.alarmSays(QStringLiteral("The drive of the third axis (polarisation) does not reply")));
    rig.link->pair().third().setPowered(true);
    EXPECT_NE(hold(kRate, Seconds(1.5)), "");
    EXPECT_EQ(mode(), moteus::Mode::Stopped);
    EXPECT_NEAR(speed(), 0.0, 0.05);
}

// REQ-THIRD-18: After a power-up the board may not know its position. Then the third axis is not moved, unless the
// profile trusts its position.
TEST_F(ThirdAxisTest, IsNotMovedWhileItsPositionIsUnknown)
{
    rig.link->pair().third().setPowered(false);
    rig.run(Seconds(0.5));
    rig.link->pair().third().setPowered(true);
    rig.run(Seconds(0.5));
    EXPECT_THAT(hold(kRate, Seconds(0.3)), HasSubstr("does not know its position after power-up"));
    EXPECT_EQ(mode(), moteus::Mode::Stopped);
}

// REQ-THIRD-19: A fault of its drive ends the jog and needs a re-arm. The mount goes on.
TEST_F(ThirdAxisTest, NeedsARearmAfterAFault)
{
    EXPECT_EQ(hold(kRate, Seconds(1.0)), "");
    rig.link->pair().third().raiseFault(38);
    EXPECT_THAT(hold(kRate, Seconds(0.6)), HasSubstr("has a fault"));
    EXPECT_EQ(third().state, State::Fault);
    EXPECT_THAT(third().fault.toStdString(), HasSubstr("(38)"));
    EXPECT_TRUE(rig.alarmSays(QStringLiteral("The drive of the third axis (polarisation) reports fault")));
    EXPECT_NE(rig.status().state, StationState::Fault);
    EXPECT_TRUE(whyNot(Action::Rearm).isEmpty());
    ASSERT_EQ(rig.ask(request::Rearm{}), "");
    rig.run(Seconds(0.5));
    EXPECT_EQ(third().state, State::Off);
    EXPECT_NEAR(speed(), 0.0, 0.05);
    jog({});
    EXPECT_EQ(hold(kRate, Seconds(0.6)), "");
}

// REQ-THIRD-20: No client and no target moves the third axis.
TEST_F(ThirdAxisTest, FollowsNoClient)
{
    const auto client = rig.connect();
    EXPECT_EQ(client->ask("P 60 40\n"), "RPRT 0\n");
    EXPECT_TRUE(rig.settle());
    EXPECT_EQ(mode(), moteus::Mode::Stopped);
    EXPECT_EQ(hold(kRate, Seconds(0.6)), "") << "it is jogged while a client has control";
    EXPECT_EQ(rig.status().authority, Authority::Clients);
}

// REQ-THIRD-21: A fault of the mount stops the third axis, too.
TEST_F(ThirdAxisTest, StopsWithAFaultOfTheMount)
{
    const auto client = rig.connect();
    EXPECT_EQ(client->ask("P 60 40\n"), "RPRT 0\n");
    EXPECT_EQ(hold(kRate, Seconds(1.0)), "");
    rig.link->pair().drive(Axis::Azimuth).raiseFault(38);
    EXPECT_THAT(hold(kRate, Seconds(1.2)), HasSubstr("Re-arm first"));
    EXPECT_NEAR(speed(), 0.0, 0.05);
}

// REQ-THIRD-22: An axis that something blocks gets no set-point far ahead of it, so it does not jump once it is free.
TEST_F(ThirdAxisTest, EndsWhenItIsBlocked)
{
    rig.link->pair().third().plant().setStalled(true);
    EXPECT_THAT(hold(kRate, Seconds(2.5)), HasSubstr("Release the button"));
    EXPECT_TRUE(rig.logSays(QStringLiteral("something blocks it")));
    const double blocked = truth();
    rig.link->pair().third().plant().setStalled(false);
    rig.run(Seconds(1.0));
    EXPECT_NEAR(truth(), blocked, 0.5);
}

// REQ-THIRD-23: While the bus is released to other tools, the third axis gets no frame.
TEST_F(ThirdAxisTest, IsLeftAloneOnAReleasedBus)
{
    ASSERT_EQ(rig.ask(request::ReleaseBus{}), "");
    EXPECT_THAT(jog(kRate), HasSubstr("released to other tools"));
    jog({});
    ASSERT_EQ(rig.ask(request::TakeBus{}), "");
    rig.run(Seconds(2.5));
    EXPECT_EQ(hold(kRate, Seconds(0.6)), "");
}

class OtherFirmware : public ThirdAxisTest
{
protected:
    OtherFirmware() { rig.link->pair().third().setRegisterMapVersion(4); }
};

// REQ-THIRD-24: A board with another register map is never commanded.
TEST_F(OtherFirmware, IsNeverCommanded)
{
    rig.link->pair().third().setPowered(false);
    rig.run(Seconds(0.5));
    rig.link->pair().third().setPowered(true);
    rig.run(Seconds(0.5));
    EXPECT_THAT(hold(kRate, Seconds(0.5)), HasSubstr("register map 4"));
    ASSERT_EQ(rig.ask(request::Stop{}), "");
    rig.run(Seconds(0.5));
    EXPECT_EQ(mode(), moteus::Mode::Stopped);
}

}  // namespace
}  // namespace boresight::system_test
