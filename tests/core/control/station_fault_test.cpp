// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/control/station_rig.h"
#include "tests/fakes/text_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace boresight {
namespace {

using moteus::Mode;

std::ptrdiff_t linesOf(const StationRig& rig, const QString& source)
{
    return std::ranges::count_if(rig.log.since(0, 1000), [&](const LogEntry& line) { return line.source == source; });
}

// REQ-CONTROL-07: A lost drive ends the motion. The healthy axis holds. Only an explicit request re-arms.
TEST(StationControl, AFaultOnOneAxisHoldsTheOtherAndWaitsForRearm)
{
    StationRig rig;
    ASSERT_TRUE(rig.setsOff(100.0, 60.0, Seconds(2.0)));
    rig.azimuth.mode = Mode::Fault;
    rig.azimuth.fault = 38;
    rig.azimuth.temperature = 76.0;
    rig.run(Seconds(2.0));
    EXPECT_EQ(rig.state(), StationState::Fault);
    const StationStatus status = rig.control.status();
    ASSERT_FALSE(status.alarms.empty());
    EXPECT_TRUE(status.alarms.front().what.startsWith(QStringLiteral("The azimuth drive reports fault 38")));
    const auto lines = rig.log.since(0, 100);
    EXPECT_TRUE(std::ranges::any_of(lines, [](const LogEntry& line) {
        return line.source == QStringLiteral("azimuth drive") && line.text.startsWith(QStringLiteral("Fault 38: "));
    })) << "the name is the source already";
    EXPECT_EQ(status.azimuth.state, AxisState::Fault);
    EXPECT_EQ(rig.elevation.mode, Mode::Position);
    const double rest = rig.elevationDegrees();
    EXPECT_FALSE(rig.point(100.0, 60.0));
    rig.run(Seconds(1.0));
    EXPECT_EQ(rig.elevationDegrees(), rest);

    EXPECT_FALSE(rig.ask(request::Rearm{})) << "still hot";
    rig.azimuth.temperature = 60.0;
    rig.run(Seconds(0.2));
    ASSERT_TRUE(rig.ask(request::Rearm{}));
    rig.run(Seconds(0.2));
    EXPECT_EQ(rig.state(), StationState::Standby);
    EXPECT_EQ(rig.azimuth.mode, Mode::Stopped);
    EXPECT_EQ(rig.elevation.mode, Mode::Position) << "the healthy axis never goes limp";
    ASSERT_TRUE(rig.point(100.0, 60.0, kOperator));
    rig.settle();
    EXPECT_NEAR(rig.azimuthDegrees(), 100.0, 0.001);
}

// REQ-CONTROL-05: A fault is latched in every phase, also at the start.
TEST(StationControl, AFaultAtStartIsShownAndNeedsRearm)
{
    StationRig rig;
    rig.azimuth.mode = Mode::Fault;
    rig.azimuth.fault = 35;
    rig.run(Seconds(0.2));
    EXPECT_EQ(rig.state(), StationState::Fault);
    EXPECT_TRUE(rig.control.status().alarms.front().what.contains(QStringLiteral("35")));
    EXPECT_FALSE(rig.point(10.0, 10.0));
    rig.run(Seconds(0.5));
    EXPECT_EQ(rig.commands(), 0U);
    ASSERT_TRUE(rig.ask(request::Rearm{}));
    rig.run(Seconds(0.2));
    EXPECT_EQ(rig.state(), StationState::Standby);
    EXPECT_EQ(rig.azimuth.mode, Mode::Stopped);
}

// REQ-CONTROL-05
TEST(StationControl, AFaultInStandbyIsShownToo)
{
    StationRig rig;
    rig.run(Seconds(0.5));
    rig.elevation.mode = Mode::Fault;
    rig.elevation.fault = 43;
    rig.elevation.position = std::nan("");  // a drive without an encoder replies, but reports no position
    rig.run(Seconds(0.2));
    EXPECT_EQ(rig.state(), StationState::Fault);
    EXPECT_TRUE(rig.control.status().alarms.front().what.contains(QStringLiteral("43")));
    EXPECT_FALSE(rig.control.measured());
}

TEST(StationControl, ReArmingIsTheOperatorsWhileTheOperatorHasTakenOver)
{
    StationRig rig;
    ASSERT_TRUE(rig.setsOff(100.0, 60.0, Seconds(1.0)));
    rig.azimuth.mode = Mode::Fault;
    rig.azimuth.fault = 38;
    rig.azimuth.temperature = 76.0;
    rig.run(Seconds(0.2));
    rig.azimuth.temperature = 60.0;
    rig.run(Seconds(0.2));
    ASSERT_TRUE(rig.ask(request::TakeAuthority{}));
    EXPECT_EQ(rig.ask(request::Rearm{}, kClient).error().code, ErrorCode::Refused);
    EXPECT_TRUE(rig.ask(request::Rearm{}));
}

TEST(StationControl, AFaultThatComesBackIsShownAgain)
{
    StationRig rig;
    ASSERT_TRUE(rig.setsOff(100.0, 60.0, Seconds(1.0)));
    for (int i = 0; i < 2; ++i) {
        rig.azimuth.mode = Mode::Fault;
        rig.azimuth.fault = 40;
        rig.run(Seconds(0.2));
        EXPECT_EQ(rig.state(), StationState::Fault);
        ASSERT_TRUE(rig.ask(request::Rearm{}));
        rig.run(Seconds(0.2));
        EXPECT_EQ(rig.state(), StationState::Standby);
        ASSERT_TRUE(rig.point(100.0, 60.0, kOperator));
        rig.run(Seconds(0.2));
    }
}

TEST(StationControl, ATimeOutLeftFromAnEarlierProgramIsClearedByTheFirstCommand)
{
    StationRig rig;
    rig.azimuth.mode = rig.elevation.mode = Mode::PositionTimeout;
    rig.run(Seconds(1.0));
    EXPECT_EQ(rig.state(), StationState::Standby);
    EXPECT_EQ(rig.control.status().azimuth.state, AxisState::Holding) << "it holds by itself: no fault of now";
    EXPECT_EQ(rig.commands(), 0U);
    ASSERT_TRUE(rig.point(10.0, 10.0));
    rig.settle();
    EXPECT_EQ(rig.azimuth.seen.front().mode, Mode::Stopped);
    EXPECT_NEAR(rig.azimuthDegrees(), 10.0, 0.001);
}

// REQ-CONTROL-07
TEST(StationControl, ADriveThatIgnoresUsIsAFault)
{
    StationRig rig;
    rig.elevation.deaf = true;
    ASSERT_TRUE(rig.setsOff(10.0, 10.0, Seconds(1.5)));
    EXPECT_EQ(rig.state(), StationState::Fault);
    EXPECT_EQ(rig.azimuthDegrees(), 0.0) << "no axis moves before both hold";
}

// Story: a second drive had a fault a moment before the re-arm. The re-arm cleared it with the first one, unreported.
TEST(StationControl, AFaultThatNobodyWasToldIsNotClearedWithAnother)
{
    StationRig rig;
    ASSERT_TRUE(rig.setsOff(100.0, 30.0, Seconds(1.0)));
    rig.azimuth.mode = Mode::Fault;
    rig.azimuth.fault = 33;
    rig.run(Seconds(2.0));
    ASSERT_EQ(rig.state(), StationState::Fault);
    rig.elevation.mode = Mode::Fault;
    rig.elevation.fault = 32;
    rig.tick();
    ASSERT_TRUE(rig.ask(request::Rearm{}));
    rig.run(Seconds(0.5));
    EXPECT_EQ(rig.state(), StationState::Fault);
    EXPECT_EQ(rig.elevation.mode, Mode::Fault) << "not before somebody has read why";
    ASSERT_TRUE(rig.ask(request::Rearm{}));
    rig.run(Seconds(0.5));
    EXPECT_EQ(rig.state(), StationState::Standby);
}

TEST(StationControl, ADriveWithoutAPositionIsNotMoved)
{
    StationRig rig;
    rig.elevation.position = std::numeric_limits<double>::quiet_NaN();
    rig.run(Seconds(0.5));
    EXPECT_EQ(textOf(rig.point(10.0, 10.0, kOperator).error()),
              "The elevation drive reports no position. Check its encoder.");
    EXPECT_FALSE(rig.ask(request::Jog{{.azimuth = 1_deg_s}}));
    EXPECT_FALSE(rig.ask(request::ProveCrashStop{2_deg_s}));
    EXPECT_EQ(rig.commands(), 0U);
}

// REQ-CONTROL-07
TEST(StationControl, ADriveThatWasPowerCycledIsNotCommandedOn)
{
    StationRig rig;
    ASSERT_TRUE(rig.setsOff(100.0, 60.0, Seconds(1.0)));
    rig.azimuth.mode = Mode::Stopped;
    rig.azimuth.home = moteus::HomeState::Rotor;
    rig.azimuth.position = 0.4;
    rig.azimuth.deaf = true;
    rig.run(Seconds(0.2));
    EXPECT_EQ(rig.state(), StationState::Fault);
    const std::size_t before = rig.azimuth.seen.size();
    rig.run(Seconds(1.0));
    EXPECT_EQ(rig.azimuth.seen.size(), before);
}

TEST(StationControl, AnActiveLimitIsAHintNotAFault)
{
    StationRig rig;
    ASSERT_TRUE(rig.setsOff(100.0, 60.0, Seconds(1.0)));
    rig.azimuth.deaf = true;  // so the code below is not cleared
    rig.azimuth.fault = 100;
    rig.tick();
    rig.tick();
    EXPECT_EQ(rig.state(), StationState::Slew);
    ASSERT_FALSE(rig.control.status().alarms.empty());
    EXPECT_EQ(rig.control.status().alarms.front().severity, Severity::Warning);
}

// REQ-ALARMS-305: When a drive limits its torque because its board or motor is warm, the alarm names the temperature.
// The sentence on the screen follows the temperature. It stays one alarm with one line in the log, also if a reply has
// no temperature.
TEST(StationControl, ALimitByHeatNamesTheTemperature)
{
    StationRig rig;
    ASSERT_TRUE(rig.setsOff(100.0, 60.0, Seconds(1.0)));
    int code = 100;
    rig.onTick = [&] { rig.azimuth.fault = code; };
    rig.azimuth.temperature = 55.6;
    rig.run(Seconds(0.1));
    ASSERT_FALSE(rig.control.status().alarms.empty());
    const Alarm first = rig.control.status().alarms.front();
    EXPECT_EQ(first.severity, Severity::Warning);
    EXPECT_EQ(first.what, QStringLiteral("The azimuth drive limits its torque: its board is at 56 °C."));
    EXPECT_EQ(rig.lastLog().find("Limit 100: its board is at 56 °C."), 0U) << rig.lastLog();
    const auto lines = linesOf(rig, QStringLiteral("azimuth drive"));
    for (const double next : {58.0, std::nan("")}) {
        rig.azimuth.temperature = next;
        rig.run(Seconds(0.1));
        const Alarm now = rig.control.status().alarms.front();
        EXPECT_EQ(now.what, QStringLiteral("The azimuth drive limits its torque: its board is at 58 °C."));
        EXPECT_EQ(now.id, first.id);
    }
    EXPECT_EQ(linesOf(rig, QStringLiteral("azimuth drive")), lines);
    code = 101;
    rig.azimuth.motorTemperature = 70.0;
    rig.run(Seconds(0.1));
    EXPECT_EQ(rig.control.status().alarms.front().what,
              QStringLiteral("The azimuth drive limits its torque: its motor is at 70 °C."));
}

// REQ-ALARMS-306: While a fault by heat lasts, its alarm shows the temperature at the fault and the present one. It
// stays one alarm with one line in the log. A re-arm is refused with the temperature until the drive is cool.
TEST(StationControl, AFaultByHeatShowsHowTheDriveCoolsDown)
{
    StationRig rig;
    ASSERT_TRUE(rig.setsOff(100.0, 60.0, Seconds(1.0)));
    rig.azimuth.mode = Mode::Fault;
    rig.azimuth.fault = 38;
    rig.azimuth.temperature = 76.0;
    rig.azimuth.motorTemperature = 50.0;
    rig.run(Seconds(0.5));
    const Alarm first = rig.control.status().alarms.front();
    EXPECT_EQ(first.name, QStringLiteral("drive.fault"));
    EXPECT_TRUE(
        first.remedy.endsWith(QStringLiteral(". The board is at 76 °C. The motor is at 50 °C. Then press "
                                             "Re-arm.")))
        << first.remedy.toStdString();
    const auto lines = linesOf(rig, QStringLiteral("azimuth drive"));
    rig.azimuth.temperature = 71.0;
    rig.run(Seconds(0.5));
    const Alarm now = rig.control.status().alarms.front();
    EXPECT_TRUE(now.remedy.contains(QStringLiteral("The board was at 76 °C and is at 71 °C now.")))
        << now.remedy.toStdString();
    EXPECT_EQ(now.id, first.id);
    EXPECT_EQ(linesOf(rig, QStringLiteral("azimuth drive")), lines);

    const Result<> refused = rig.ask(request::Rearm{});
    ASSERT_FALSE(refused);
    EXPECT_TRUE(
        refused.error().text.contains(QStringLiteral("The drive board is still at 71 °C. It must cool down to 70 °C.")))
        << textOf(refused.error());
    rig.azimuth.temperature = 69.0;
    rig.run(Seconds(0.2));
    ASSERT_TRUE(rig.ask(request::Rearm{}));
    rig.run(Seconds(0.5));
    EXPECT_EQ(rig.state(), StationState::Standby);
    const auto alarms = rig.control.status().alarms;
    EXPECT_TRUE(std::ranges::none_of(
        alarms, [](const Alarm& one) { return one.active && one.name == QStringLiteral("drive.fault"); }));
}

// Story: in a random walk an interlock appeared during a motion, and the mount went on moving.
// REQ-CONTROL-18
TEST(StationControl, DrivesThatAreNotFitAnyMoreAreNotMovedOn)
{
    StationRig rig;
    rig.run(Seconds(0.5));
    ASSERT_TRUE(rig.ask(request::Move{{.azimuth = 5_deg_s}}));
    rig.run(Seconds(2.0));
    ASSERT_TRUE(rig.moving());
    rig.mount.setInterlock(failure(ErrorCode::Refused, QStringLiteral("not as it should be")));
    rig.run(Seconds(1.5));
    EXPECT_FALSE(rig.moving());
    EXPECT_EQ(rig.state(), StationState::Hold);
    rig.mount.setInterlock({});
    rig.run(Seconds(1.0));
    EXPECT_FALSE(rig.moving()) << "and nothing comes back by itself";
}

// Story: a random walk switched the drives off during a re-arm. The fault vanished from the screen while a drive was
// still in fault.
TEST(StationControl, DrivesAreNotSwitchedOffInTheMidstOfARearm)
{
    StationRig rig;
    rig.run(Seconds(0.5));
    ASSERT_TRUE(rig.point(10.0, 10.0));
    rig.settle();
    rig.elevation.mode = moteus::Mode::Fault;
    rig.elevation.fault = 38;
    rig.elevation.deaf = true;
    rig.run(Seconds(0.5));
    ASSERT_TRUE(rig.control.faultLatched());
    ASSERT_TRUE(rig.ask(request::Rearm{}));
    rig.tick();
    EXPECT_FALSE(rig.ask(request::SwitchOff{}));
    rig.run(Seconds(0.2));
    EXPECT_TRUE(rig.control.faultLatched());
}

// REQ-CONTROL-930: The drive of one axis can be switched off alone while nothing moves. Its axis shows OFF, and the
// other axis still holds. Nothing is switched on again before the operator moves the mount, and clients are refused
// until then. The action is not offered for a drive that is already off.
TEST(StationControl, TheDriveOfOneAxisIsSwitchedOffAlone)
{
    StationRig rig;
    rig.run(Seconds(0.5));
    ASSERT_TRUE(rig.point(10.0, 10.0));
    EXPECT_FALSE(rig.ask(request::SwitchOff{Axis::Elevation})) << "the mount moves";
    rig.settle();
    ASSERT_TRUE(rig.ask(request::SwitchOff{Axis::Elevation}));
    rig.run(Seconds(10.0));
    EXPECT_EQ(rig.lastLog(), "switches the elevation drive off, so nothing holds its axis");
    StationStatus status = rig.control.status();
    EXPECT_EQ(status.elevation.state, AxisState::Off);
    EXPECT_EQ(status.azimuth.state, AxisState::Holding);
    EXPECT_EQ(rig.elevation.mode, moteus::Mode::Stopped);
    EXPECT_EQ(rig.azimuth.mode, moteus::Mode::Position);
    EXPECT_FALSE(rig.control.faultLatched());
    EXPECT_FALSE(status.permissions.allows(Action::SwitchOffElevation));
    EXPECT_TRUE(status.permissions.allows(Action::SwitchOffAzimuth));
    EXPECT_TRUE(status.permissions.allows(Action::SwitchOff));
    const double held = rig.azimuth.position;
    ASSERT_TRUE(rig.ask(request::PointAxes{{.azimuth = 20_deg, .elevation = 12_deg}}));
    rig.settle();
    EXPECT_NE(rig.azimuth.position, held);
    EXPECT_EQ(rig.control.status().elevation.state, AxisState::Holding);
    EXPECT_NEAR(rig.elevationDegrees(), 12.0, 0.001);
}

// REQ-CONTROL-931: The status gives the reason why the drive of one axis cannot be switched off alone: it is already
// off, or the axis has no drive of its own.
TEST(StationControl, ADriveThatIsOffIsNotSwitchedOffAgain)
{
    StationRig rig;
    rig.run(Seconds(0.5));
    const Result<> off = rig.ask(request::SwitchOff{Axis::Azimuth});
    ASSERT_FALSE(off);
    EXPECT_EQ(textOf(off.error()), "The azimuth drive is switched off already.");
    EXPECT_EQ(rig.control.status().permissions.reason(Action::SwitchOffAzimuth),
              QStringLiteral("The azimuth drive is switched off already."));
}

}  // namespace
}  // namespace boresight
