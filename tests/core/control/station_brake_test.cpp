// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/control/station_rig.h"
#include "tests/fakes/text_of.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace boresight {
namespace {

using brake::BrakeState;
using moteus::Mode;
using testing::HasSubstr;

profile::Profile braked()
{
    profile::Profile profile;
    profile.brake = {.output = "rts:/dev/ttyUSB0", .switching = Seconds(0.4), .setAfter = Seconds(5.0)};
    return profile;
}

// A mount with a brake. The output of the brake answers one tick after its order, as long as it works.
class StationBrakeTest : public testing::Test
{
protected:
    StationBrakeTest() { run(Seconds(1.6)); }

    void tick()
    {
        if (rig.control.releasesBrake() != released) {
            released = rig.control.releasesBrake();
            places = {rig.azimuth.position, rig.elevation.position};
            // A brake that is set under a moving antenna.
            setWhileMoving = setWhileMoving || (!released && moves());
        }
        rig.control.takeBrake(problem.isEmpty()
                                  ? contacts::OutputAnswer{.isOn = answers ? std::optional(released) : std::nullopt}
                                  : contacts::OutputAnswer{.problem = problem});
        rig.tick();
        fastest = std::max({fastest, speed(Axis::Azimuth), speed(Axis::Elevation)});
    }
    void run(Seconds time)
    {
        for (int i = 0; i < static_cast<int>(time / rig.step + 0.5); ++i) {
            tick();
        }
    }
    [[nodiscard]] double speed(Axis axis) const
    {
        const StationStatus status = rig.control.status();
        const AxisStatus& shown = axis == Axis::Azimuth ? status.azimuth : status.elevation;
        return std::abs(shown.commandedRate.value_or(AngularRate{}).degrees());
    }
    [[nodiscard]] bool moves() const { return speed(Axis::Azimuth) > 0.0 || speed(Axis::Elevation) > 0.0; }
    [[nodiscard]] bool isWhereItWas() const
    {
        return std::abs(rig.azimuth.position - places[0]) < 1e-9 && std::abs(rig.elevation.position - places[1]) < 1e-9;
    }
    // Runs until the mount moves.
    void setOff()
    {
        ASSERT_TRUE(rig.point(200.0, 60.0, kOperator));
        run(Seconds(2.0));
        ASSERT_TRUE(moves());
    }

    StationRig rig{braked()};
    bool released = false;
    bool answers = true;
    QString problem;
    std::array<double, 2> places{};
    bool setWhileMoving = false;
    double fastest = 0.0;
};

// REQ-BRAKE-11: With a brake nothing moves from any source before the brake is open. Then the motion begins without
// another request. A mount that nobody moves keeps its brake set.
TEST_F(StationBrakeTest, NothingMovesBeforeTheBrakeIsOpen)
{
    const auto begins = [this](const auto& ask) {
        ASSERT_FALSE(released);
        fastest = 0.0;
        ASSERT_TRUE(ask());
        run(Seconds(0.4));
        EXPECT_TRUE(released);
        EXPECT_EQ(rig.control.status().brake.state, BrakeState::Releasing);
        EXPECT_EQ(fastest, 0.0);
        EXPECT_TRUE(isWhereItWas());
        run(Seconds(0.5));
        EXPECT_GT(fastest, 0.0);
        ASSERT_TRUE(rig.ask(request::Hold{}));
        run(Seconds(9.0));
    };
    run(Seconds(30.0));
    begins([this] { return rig.point(100.0, 30.0); });
    begins([this] { return rig.ask(request::Park{}); });
    begins([this] { return rig.ask(request::Move{{.azimuth = 1_deg_s}}); });
    begins([this] { return rig.ask(request::PointAxes{{.azimuth = 300_deg, .elevation = 10_deg}}); });
    EXPECT_FALSE(setWhileMoving);
}

// REQ-BRAKE-11
TEST_F(StationBrakeTest, WithoutAnAnswerOfTheOutputNothingMoves)
{
    answers = false;
    ASSERT_TRUE(rig.point(200.0, 60.0, kOperator));
    run(Seconds(20.0));
    EXPECT_TRUE(released);
    EXPECT_EQ(fastest, 0.0);
}

// REQ-BRAKE-12: When the mount has stood still for the time of the profile, the brake is set. The drives hold the axes
// meanwhile. The next motion releases it again.
TEST_F(StationBrakeTest, IsSetAfterTheMotion)
{
    ASSERT_TRUE(rig.point(20.0, 10.0, kOperator));
    run(Seconds(2.0));
    ASSERT_TRUE(moves());
    while (moves()) {
        tick();
    }
    run(Seconds(4.0));
    EXPECT_TRUE(released);
    run(Seconds(3.0));
    EXPECT_FALSE(released);
    EXPECT_EQ(rig.control.status().brake.state, BrakeState::Set);
    EXPECT_EQ(rig.azimuth.mode, Mode::Position);
    EXPECT_FALSE(setWhileMoving);
    ASSERT_TRUE(rig.point(40.0, 10.0, kOperator));
    run(Seconds(1.0));
    EXPECT_TRUE(moves());
}

// REQ-BRAKE-13: STOP first stops the mount, then the brake is set. While the brake opens, STOP sets it at once. Nothing
// moves by itself after the reset.
TEST_F(StationBrakeTest, StopSetsItAtStandstill)
{
    setOff();
    ASSERT_TRUE(rig.ask(request::Stop{}));
    while (moves()) {
        tick();
        ASSERT_TRUE(released || !moves());
    }
    run(Seconds(1.5));
    EXPECT_FALSE(released);
    EXPECT_FALSE(setWhileMoving);
    ASSERT_TRUE(rig.ask(request::ResetStop{}));
    fastest = 0.0;
    run(Seconds(10.0));
    EXPECT_FALSE(released);
    EXPECT_EQ(fastest, 0.0);
}

// REQ-BRAKE-13
TEST_F(StationBrakeTest, StopWhileItOpens)
{
    ASSERT_TRUE(rig.point(200.0, 60.0, kOperator));
    run(Seconds(0.3));
    ASSERT_TRUE(released);
    ASSERT_TRUE(rig.ask(request::Stop{}));
    run(Seconds(0.06));
    EXPECT_FALSE(released);
    run(Seconds(10.0));
    EXPECT_FALSE(released);
    EXPECT_EQ(fastest, 0.0);
}

// Story: the wish for a motion was one tick old when STOP came, and it opened the brake.
// REQ-BRAKE-13
TEST_F(StationBrakeTest, StopRightAfterARequestKeepsItSet)
{
    const auto staysSetAfter = [this](const Request& end) {
        ASSERT_TRUE(rig.point(200.0, 60.0, kOperator));
        tick();
        ASSERT_TRUE(rig.ask(end));
        for (int i = 0; i < 500; ++i) {
            tick();
            ASSERT_FALSE(released);
        }
    };
    staysSetAfter(request::Stop{});
    ASSERT_TRUE(rig.ask(request::ResetStop{}));
    staysSetAfter(request::SwitchOff{});
    EXPECT_EQ(fastest, 0.0);
}

// Story: an interlock appeared while the brake opened. The set-points stood still, so the motion did not end, and the
// mount began to move when the brake was open.
// REQ-BRAKE-29: An interlock that appears while the brake opens ends the motion.
TEST_F(StationBrakeTest, AnInterlockWhileItOpensEndsTheMotion)
{
    ASSERT_TRUE(rig.point(200.0, 60.0, kOperator));
    run(Seconds(0.3));
    ASSERT_TRUE(released);
    rig.mount.setInterlock(failure(ErrorCode::Refused, QStringLiteral("not as it should be")));
    run(Seconds(10.0));
    EXPECT_EQ(fastest, 0.0);
    EXPECT_FALSE(released);
    EXPECT_EQ(rig.state(), StationState::Hold);
}

// REQ-BRAKE-14: An output that fails during a motion stops the mount. This is a fault: the brake is set at standstill,
// the alarm names the output, and the mount moves again only after a re-arm and a request.
TEST_F(StationBrakeTest, AFailureStopsTheMount)
{
    setOff();
    problem = QStringLiteral("unplugged");
    run(Seconds(0.06));
    EXPECT_EQ(rig.state(), StationState::Fault);
    while (moves()) {
        tick();
        ASSERT_TRUE(released || !moves());
    }
    run(Seconds(2.0));
    EXPECT_FALSE(released);
    EXPECT_FALSE(setWhileMoving);
    const StationStatus status = rig.control.status();
    ASSERT_FALSE(status.alarms.empty());
    EXPECT_EQ(status.alarms.front().what,
              QStringLiteral("The brake output rts:/dev/ttyUSB0 does not work: unplugged."));
    EXPECT_EQ(rig.point(10.0, 10.0, kOperator).error().text, QStringLiteral("brake output: unplugged. Re-arm first."));
    problem.clear();
    fastest = 0.0;
    run(Seconds(10.0));
    EXPECT_EQ(rig.state(), StationState::Fault) << "nothing is re-armed by itself";
    ASSERT_TRUE(rig.ask(request::Rearm{}));
    run(Seconds(10.0));
    EXPECT_EQ(fastest, 0.0);
    EXPECT_FALSE(released);
    setOff();
}

// REQ-BRAKE-14
TEST_F(StationBrakeTest, AFailureWhileItOpensMovesNothing)
{
    ASSERT_TRUE(rig.point(200.0, 60.0, kOperator));
    run(Seconds(0.3));
    problem = QStringLiteral("no broker");
    run(Seconds(1.0));
    problem.clear();
    run(Seconds(10.0));
    EXPECT_EQ(rig.state(), StationState::Fault);
    EXPECT_EQ(fastest, 0.0);
    EXPECT_FALSE(released);
}

// REQ-BRAKE-15: While the output does not work, every motion is refused with the reason. If nothing moves, it is no
// fault: the mount may move again as soon as the output works.
TEST_F(StationBrakeTest, AnOutputThatFailsRefusesEveryMotion)
{
    problem = QStringLiteral("no broker");
    run(Seconds(1.0));
    EXPECT_NE(rig.state(), StationState::Fault);
    const QString why = QStringLiteral("The brake output does not work: no broker. Check the output.");
    EXPECT_EQ(rig.point(10.0, 10.0, kOperator).error().text, why);
    EXPECT_EQ(rig.point(10.0, 10.0).error().text, why);
    EXPECT_EQ(rig.ask(request::Park{}).error().text, why);
    EXPECT_EQ(rig.ask(request::Jog{{.azimuth = 1_deg_s}}).error().text, why);
    EXPECT_THAT(rig.control.status().permissions.reason(Action::Point).toStdString(), HasSubstr("no broker"));
    problem.clear();
    run(Seconds(1.0));
    EXPECT_TRUE(rig.control.status().alarms.empty() || !rig.control.status().alarms.front().active);
    setOff();
}

// REQ-BRAKE-16: A drive in fault holds nothing, so the brake is set at once. A silent drive gets 2 s to stop.
TEST_F(StationBrakeTest, ADriveInFaultIsHeldByTheBrake)
{
    setOff();
    rig.elevation.mode = Mode::Fault;
    rig.elevation.fault = 35;
    run(Seconds(0.1));
    EXPECT_FALSE(released);
    run(Seconds(10.0));
    EXPECT_FALSE(released);
}

// REQ-BRAKE-16
TEST_F(StationBrakeTest, ASilentDriveGetsTimeToStop)
{
    setOff();
    rig.azimuth.silent = true;
    run(Seconds(1.5));
    EXPECT_TRUE(released);
    run(Seconds(4.0));
    EXPECT_FALSE(released);
    rig.azimuth.silent = false;
    fastest = 0.0;
    run(Seconds(10.0));
    EXPECT_FALSE(released) << "nothing moves by itself";
    EXPECT_EQ(fastest, 0.0);
}

// REQ-BRAKE-17: At the end of the program the mount stops, then the brake is set, and only then the drives are left. If
// the brake cannot be set, the drives are not switched off.
TEST_F(StationBrakeTest, TheEndSetsItBeforeTheDrivesAreLeft)
{
    profile::Profile off = braked();
    off.control.onExit = profile::OnExit::Off;
    rig.setProfile(off);
    setOff();
    rig.control.shutDown();
    for (int i = 0; i < 1000 && rig.azimuth.mode == Mode::Position; ++i) {
        tick();
    }
    EXPECT_FALSE(released);
    EXPECT_FALSE(setWhileMoving);
    EXPECT_EQ(rig.control.status().brake.state, BrakeState::Set);
    run(Seconds(1.0));
    EXPECT_TRUE(rig.control.shutDownDone());
    EXPECT_EQ(rig.elevation.mode, Mode::Stopped);
}

// REQ-BRAKE-17
TEST_F(StationBrakeTest, TheEndWithoutABrakeLeavesTheDrivesHolding)
{
    profile::Profile off = braked();
    off.control.onExit = profile::OnExit::Off;
    rig.setProfile(off);
    setOff();
    problem = QStringLiteral("unplugged");
    rig.control.shutDown();
    for (int i = 0; i < 2000 && !rig.control.shutDownDone(); ++i) {
        tick();
    }
    EXPECT_TRUE(rig.control.shutDownDone());
    EXPECT_NE(rig.elevation.mode, Mode::Stopped);
}

// REQ-BRAKE-18: The drives are not switched off and the bus is not released while the brake is released, or may be
// released because its output does not work.
TEST_F(StationBrakeTest, TheDrivesStayOnUntilItIsSet)
{
    ASSERT_TRUE(rig.point(20.0, 10.0, kOperator));
    run(Seconds(2.0));
    ASSERT_TRUE(rig.ask(request::Hold{}));
    run(Seconds(3.0));
    ASSERT_TRUE(released);
    EXPECT_EQ(rig.ask(request::SwitchOff{}).error().text,
              QStringLiteral("The brake is not set yet. Wait until nothing has moved for 5 s."));
    EXPECT_FALSE(rig.ask(request::ReleaseBus{}));
    problem = QStringLiteral("unplugged");
    run(Seconds(10.0));
    EXPECT_THAT(rig.ask(request::SwitchOff{}).error().text.toStdString(), HasSubstr("The brake may be open."));
    problem.clear();
    run(Seconds(5.0));
    ASSERT_FALSE(released);
    EXPECT_TRUE(rig.ask(request::SwitchOff{}));
}

// REQ-BRAKE-19: Another output is refused while the brake is released or the mount moves.
TEST_F(StationBrakeTest, AnotherOutputOnlyWhileItIsSet)
{
    profile::Profile other = braked();
    other.brake.output = "dtr:/dev/ttyUSB0";
    setOff();
    EXPECT_THAT(textOf(rig.ask(request::ApplyProfile{other}).error()), HasSubstr("brake.output"));
    ASSERT_TRUE(rig.ask(request::Hold{}));
    run(Seconds(9.0));
    EXPECT_TRUE(rig.ask(request::ApplyProfile{other}));
}

// REQ-BRAKE-20: The crash-stop test waits for the brake, which stays open until the test ends.
TEST_F(StationBrakeTest, TheCrashStopTestWaitsForIt)
{
    ASSERT_TRUE(rig.ask(request::PointAxes{{.azimuth = 180_deg, .elevation = 45_deg}}));
    run(Seconds(40.0));
    ASSERT_FALSE(released);
    ASSERT_TRUE(rig.ask(request::ProveCrashStop{5_deg_s}));
    fastest = 0.0;
    run(Seconds(0.4));
    EXPECT_TRUE(released);
    EXPECT_EQ(fastest, 0.0);
    run(Seconds(12.0));
    EXPECT_THAT(rig.log.since(0, 1000).back().text.toStdString(), HasSubstr("crash-stop test: "));
    EXPECT_FALSE(setWhileMoving);
}

// REQ-BRAKE-21: Without a brake in the profile nothing waits.
TEST(StationControl, WithoutABrakeNothingWaits)
{
    StationRig rig;
    rig.run(Seconds(0.2));
    ASSERT_TRUE(rig.point(100.0, 30.0));
    rig.run(Seconds(0.2));
    EXPECT_EQ(rig.state(), StationState::Slew);
    EXPECT_FALSE(rig.control.releasesBrake());
    EXPECT_NE(rig.control.status().azimuth.commandedRate.value_or(AngularRate{}), AngularRate{});
    EXPECT_TRUE(rig.control.status().brake.output.isEmpty());
}

}  // namespace
}  // namespace boresight
