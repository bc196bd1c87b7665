// SPDX-License-Identifier: GPL-3.0-or-later
// Tests problems that a drive does not report: it stalls, jumps or runs away while its status is good.
#include "tests/core/control/station_rig.h"
#include "tests/fakes/text_of.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace boresight {
namespace {

using ::testing::HasSubstr;

// A mount with an azimuth drive whose reports the test changes between two ticks.
struct WatchRig : StationRig
{
    WatchRig()
    {
        run(Seconds(0.5));
        EXPECT_TRUE(ask(request::PointAxes{{100_deg, 45_deg}}));
        settle();
    }

    // Runs until the station has stopped the mount. Returns the time that took.
    Seconds untilFault(const std::function<void()>& spoil, Seconds limit = Seconds(5.0))
    {
        Seconds time{0.0};
        for (; time < limit && state() != StationState::Fault; time += kTick) {
            tick();
            spoil();
        }
        EXPECT_EQ(state(), StationState::Fault);
        return time;
    }

    // The alarm with all its parts, or an empty text if there is none.
    [[nodiscard]] std::string alarm(const char* words) const
    {
        for (const Alarm& one : control.status().alarms) {
            if (one.what.contains(QString::fromUtf8(words))) {
                return (one.what + QLatin1Char(' ') + one.action + QLatin1Char(' ') + one.remedy).toStdString();
            }
        }
        return {};
    }

    void expectStoppedAndRearmable()
    {
        run(Seconds(2.0));
        const AxisStatus axis = control.status().azimuth;
        ASSERT_TRUE(axis.commanded);
        EXPECT_NEAR(axis.commanded->degrees(), axis.actual->degrees(), 0.01) << "it is not pulled to the old target";
        EXPECT_EQ(point(10.0, 10.0, kOperator).error().code, ErrorCode::Refused);
        ASSERT_TRUE(ask(request::Rearm{}));
        run(Seconds(1.0));
        EXPECT_EQ(state(), StationState::Standby) << control.status().stateReason.toStdString();
    }
};

// REQ-AXES-19 (StationWatch.*): Boresight detects what the drive does not report, and stops the mount with the reason.
// REQ-AXES-19c
TEST(StationWatch, AStalledAxisStopsTheMountWithinASecond)
{
    WatchRig rig;
    ASSERT_TRUE(rig.ask(request::PointAxes{{200_deg, 45_deg}}));
    rig.run(Seconds(3.0));
    const double stuck = rig.azimuth.position;
    const Seconds time = rig.untilFault([&] { rig.azimuth.position = stuck; });
    EXPECT_LE(time, Seconds(1.1));
    const std::string said = rig.alarm("The azimuth");
    EXPECT_THAT(said, HasSubstr("Boresight stopped the mount and holds it."));
    EXPECT_THAT(said, HasSubstr("press Re-arm."));
    rig.run(Seconds(0.5));
    rig.expectStoppedAndRearmable();
    ASSERT_TRUE(rig.ask(request::PointAxes{{110_deg, 45_deg}})) << "free again";
    rig.settle();
    EXPECT_NEAR(rig.azimuthDegrees(), 110.0, 0.01);
}

// Story: the drive was blocked, and its integrator went on pushing with full torque even through the re-arm.
// REQ-AXES-19d: A blocked axis is not pushed on after the stop, nor after the re-arm, and an unbalanced axis does not
// fall. Its drive restarts its control loop at the measured position of the axis, without the integrator until the next
// motion.
TEST(StationWatch, ABlockedDriveDropsWhatItsIntegratorHasWoundUpUntilItMovesAgain)
{
    using moteus::Register;
    WatchRig rig;
    ASSERT_TRUE(rig.ask(request::PointAxes{{200_deg, 45_deg}}));
    rig.run(Seconds(3.0));
    const double stuck = rig.azimuth.position;
    rig.untilFault([&] { rig.azimuth.position = stuck; });
    rig.azimuth.seen.clear();
    rig.elevation.seen.clear();
    rig.run(Seconds(1.0));
    const auto& frames = rig.azimuth.seen;
    ASSERT_GT(frames.size(), 10U);
    EXPECT_TRUE(std::isnan(frames.front().fields.at(Register::CommandPosition))) << "from where the drive measures";
    EXPECT_TRUE(frames.front().fields.contains(Register::RecapturePositionVelocity));
    EXPECT_FALSE(frames.back().fields.contains(Register::RecapturePositionVelocity)) << "it would creep";
    const auto integral = [](const auto& frame) {
        return frame.fields.find(Register::CommandIntegralLimitScale).value_or(1.0);
    };
    EXPECT_TRUE(std::ranges::all_of(frames, [&](const auto& frame) { return integral(frame) == 0.0; }));
    EXPECT_TRUE(std::ranges::all_of(frames, [](const auto& frame) {
        return frame.fields.at(Register::CommandMaximumTorque) > 49.0;
    })) << "an unbalanced axis must not fall";
    EXPECT_TRUE(std::ranges::all_of(rig.elevation.seen, [&](const auto& frame) { return integral(frame) == 1.0; }));
    ASSERT_TRUE(rig.ask(request::Rearm{}));
    rig.run(Seconds(1.0));
    EXPECT_EQ(integral(rig.azimuth.seen.back()), 0.0);
    ASSERT_TRUE(rig.ask(request::PointAxes{{110_deg, 45_deg}}));
    rig.run(Seconds(1.0));
    EXPECT_EQ(integral(rig.azimuth.seen.back()), 1.0);
}

// Even with every field set, the command fits into one frame.
// REQ-AXES-19d
TEST(Drive, YieldsBeyondItsBounds)
{
    using moteus::Register;
    Drive drive({.id = 1,
                 .maxTorque = 50.0,
                 .places = {.allowance = MotorTurns::fromTurns(0.001), .speed = MotorRate::fromTurns(0.03)}},
                "azimuth drive");
    fakes::IdealDrive ideal(1, 1.3);
    SteadyTime now{};
    const auto tick = [&] {
        now += std::chrono::milliseconds(20);
        drive.judge(now);
        if (const auto reply = ideal.answer(drive.frame(), now)) {
            drive.take(*reply);
        }
    };
    tick();
    drive.setIgnoreBounds(true);
    drive.setSetpoint({.position = MotorTurns::fromTurns(ideal.position)});
    drive.engage();
    for (int i = 0; i < 10; ++i) {
        tick();
    }
    ASSERT_TRUE(drive.takeEngaged());
    drive.yield();
    tick();
    const auto& fields = ideal.seen.back().fields;
    for (const Register reg : {Register::RecapturePositionVelocity, Register::CommandIntegralLimitScale,
                               Register::CommandIgnorePositionBounds, Register::CommandWatchdogTimeout}) {
        EXPECT_TRUE(fields.contains(reg));
    }
    for (int i = 0; i < 10; ++i) {
        tick();
    }
    EXPECT_TRUE(drive.takeEngaged());
}

// Story: a low supply of 11.5 V stopped the mount. At 11.5 V the re-arm was accepted, and the alarm was cleared.
// REQ-CONTROL-23
TEST(StationWatch, ASupplyThatStoppedTheMountIsNotOverBeforeItIsBack)
{
    WatchRig rig;
    ASSERT_TRUE(rig.ask(request::PointAxes{{200_deg, 45_deg}}));
    rig.run(Seconds(1.0));
    rig.azimuth.voltage = rig.elevation.voltage = 11.5;
    rig.run(Seconds(3.0));
    ASSERT_EQ(rig.state(), StationState::Fault);
    const auto hot = rig.ask(request::Rearm{});
    ASSERT_FALSE(hot);
    EXPECT_THAT(textOf(hot.error()), HasSubstr("The supply is still at 11.5 V. It must reach 20.0 V."));
    rig.run(Seconds(1.0));
    EXPECT_EQ(rig.state(), StationState::Fault);
    EXPECT_FALSE(rig.alarm("supply of the azimuth fell to 11.5 V").empty());
    rig.azimuth.voltage = rig.elevation.voltage = 20.2;
    rig.run(Seconds(0.5));
    ASSERT_TRUE(rig.ask(request::Rearm{}));
    rig.run(Seconds(1.0));
    EXPECT_EQ(rig.state(), StationState::Standby) << rig.control.status().stateReason.toStdString();
    EXPECT_TRUE(std::ranges::none_of(rig.control.status().alarms, &Alarm::active));
}

// REQ-ALARMS-23b: An alarm whose cause is still there after the re-arm is not over. It is raised again, and stops the
// mount again if necessary.
TEST(StationWatch, AnAlarmWhoseCauseLastsIsNotOverWithTheRearm)
{
    WatchRig rig;
    ASSERT_TRUE(rig.ask(request::PointAxes{{449.5_deg, 45_deg}}));
    rig.settle();
    rig.azimuth.deaf = true;  // the axis is pushed out against its drive
    for (int i = 0; i < 30; ++i) {
        rig.azimuth.position += 0.1 / 360.0;
        rig.tick();
    }
    rig.run(Seconds(3.0));
    ASSERT_EQ(rig.state(), StationState::Fault);
    ASSERT_FALSE(rig.alarm("beyond its travel").empty());
    ASSERT_TRUE(rig.ask(request::Rearm{})) << "else nobody could jog it back";
    rig.run(Seconds(1.0));
    EXPECT_FALSE(rig.control.faultLatched());
    EXPECT_THAT(rig.alarm("beyond its travel"), HasSubstr("Jog the axis back inside"));
    EXPECT_TRUE(std::ranges::none_of(rig.log.since(0, EventLog::kCapacity), [](const LogEntry& line) {
        return line.alarm.name.startsWith(QLatin1String("axis.outside-travel")) &&
               line.text.startsWith(QLatin1String("Cleared: "));
    }));
}

TEST(StationWatch, AnAxisThatRunsAwayFromItsPlaceStopsTheMount)
{
    WatchRig rig;
    const double held = rig.azimuth.position;
    int ticks = 0;
    // The axis moves at 3°/s, whatever is commanded.
    const Seconds time =
        rig.untilFault([&] { rig.azimuth.position = held + ++ticks * (3.0 * StationRig::kTick.count() / 360.0); });
    EXPECT_LE(time, Seconds(1.7));
    EXPECT_THAT(rig.control.status().stateReason.toStdString(), HasSubstr("azimuth"));
    EXPECT_TRUE(rig.control.status().azimuth.turnKnown) << "it was seen all the way";
    rig.expectStoppedAndRearmable();
}

TEST(StationWatch, AJumpOfTheEncoderStopsTheMountAndMakesTheTurnUnknown)
{
    WatchRig rig;
    ASSERT_TRUE(rig.ask(request::PointAxes{{200_deg, 45_deg}}));
    rig.run(Seconds(3.0));
    const double before = rig.azimuth.position;
    const Seconds time = rig.untilFault([&] { rig.azimuth.position = before + 0.1; });
    EXPECT_LE(time, Seconds(0.2));
    EXPECT_THAT(rig.alarm("jumped by"), HasSubstr("faster than the axis can move"));
    EXPECT_THAT(rig.control.status().stateReason.toStdString(), HasSubstr("jumped"));
    rig.run(Seconds(1.0));
    EXPECT_TRUE(rig.ask(request::Rearm{}));
    rig.run(Seconds(0.5));
    EXPECT_FALSE(rig.control.status().azimuth.turnKnown);
    EXPECT_TRUE(rig.control.status().drives->azimuth.turnQuestion);
    EXPECT_TRUE(rig.control.status().elevation.turnKnown);
}

// Story: while a fault was latched, a second jump was not handled, and the held axis drove the whole shift. A held axis
// gets no set-point after a jump: "hold where you are" means the same to a drive whatever its angle counts from.
TEST(StationWatch, EveryJumpBehindALatchedFaultLeavesTheAxisHeld)
{
    WatchRig rig;
    const double before = rig.azimuth.position;
    rig.untilFault([&] { rig.azimuth.position = before + 0.1; });
    const double travelled = rig.azimuth.travelled;
    for (int jump = 0; jump < 3; ++jump) {
        rig.azimuth.position += 0.2;
        rig.run(Seconds(jump == 0 ? 4.0 : 0.2));  // until the detection has ended; after that, while it lasts
        EXPECT_TRUE(std::isnan(rig.azimuth.seen.back().fields.at(moteus::Register::CommandPosition))) << jump;
        EXPECT_EQ(rig.azimuth.travelled, travelled) << jump;
        EXPECT_EQ(rig.state(), StationState::Fault);
    }
    EXPECT_FALSE(rig.control.status().azimuth.turnKnown);
    rig.run(Seconds(1.0));
    EXPECT_EQ(rig.control.status().azimuth.state, AxisState::Holding);
}

TEST(StationWatch, ASilenceIsNotToldAsLateRepliesToo)
{
    WatchRig rig;
    rig.azimuth.silent = rig.elevation.silent = true;
    rig.run(Seconds(1.0));
    EXPECT_FALSE(rig.alarm("Neither drive replies").empty());
    rig.azimuth.silent = rig.elevation.silent = false;
    rig.run(Seconds(2.0));
    for (const LogEntry& line : rig.log.since(0, EventLog::kCapacity)) {
        EXPECT_FALSE(line.text.contains(QLatin1String("was late: no reply for"))) << line.text.toStdString();
    }
    rig.azimuth.silent = true;
    rig.run(Seconds(0.16));
    rig.azimuth.silent = false;
    rig.run(Seconds(0.2));
    EXPECT_THAT(rig.alarm("was late: no reply for"), HasSubstr("Boresight does not stop the mount."));
}

}  // namespace
}  // namespace boresight
