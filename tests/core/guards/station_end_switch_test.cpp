// SPDX-License-Identifier: GPL-3.0-or-later
// The control with end switches.
#include "tests/core/control/station_rig.h"
#include "tests/fakes/text_of.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace boresight {
namespace {

using end_switches::SwitchState;
using testing::HasSubstr;

profile::Profile switched()
{
    profile::Profile profile;
    profile.endSwitches.inputs = {"mqtt:a", "mqtt:b", "mqtt:c", "mqtt:d"};
    return profile;
}

// A mount with four end switches that open when they are pressed.
class StationEndSwitchTest : public testing::Test
{
protected:
    StationEndSwitchTest()
    {
        read(true);
        run(Seconds(1.6));
    }

    void read(bool isOn) { readings.fill({.isOn = isOn}); }
    contacts::InputReading& input(Axis axis, bool isUpper)
    {
        return readings.at(end_switches::indexOf({axis, isUpper}));
    }
    void run(Seconds time)
    {
        for (int i = 0; i < static_cast<int>(time / rig.step + 0.5); ++i) {
            rig.control.takeEndSwitches(readings);
            rig.tick();
        }
    }
    [[nodiscard]] Angle azimuth() const { return rig.control.mount().measured()->azimuth; }
    [[nodiscard]] bool isStill()
    {
        const AxisPosition before = *rig.control.mount().measured();
        run(Seconds(2.0));
        return *rig.control.mount().measured() == before;
    }
    [[nodiscard]] std::string alarmTexts() const
    {
        QStringList all;
        for (const Alarm& alarm : rig.control.status().alarms) {
            if (alarm.active) {
                all << alarm.name + QStringLiteral(": ") + alarm.what;
            }
        }
        return all.join(u'\n').toStdString();
    }
    // Moves up in azimuth until the switch of the upper end is pressed.
    void runInto()
    {
        ASSERT_TRUE(rig.ask(request::Move{{.azimuth = 5_deg_s}}));
        run(Seconds(3.0));
        input(Axis::Azimuth, true).isOn = false;
    }

    StationRig rig{switched()};
    EndSwitchGuard::Readings readings;
};

// REQ-ENDSWITCH-20: An axis that runs into its end switch stops at once, as hard as by STOP. This is a fault of the
// mount, and the alarm names the end. After the re-arm only the way back is open.
TEST_F(StationEndSwitchTest, StopsTheMountAndPermitsOnlyTheWayBack)
{
    runInto();
    const Angle pressedAt = azimuth();
    run(Seconds(0.6));
    EXPECT_EQ(rig.control.state(), StationState::Fault);
    EXPECT_LT(azimuth(), pressedAt + 2.5_deg);
    EXPECT_TRUE(isStill());
    EXPECT_THAT(alarmTexts(),
                HasSubstr("switch.hit: The mount ran into the end switch at the upper end of the azimuth"));
    EXPECT_FALSE(rig.ask(request::Move{{.azimuth = -1_deg_s}})) << "before the re-arm";

    ASSERT_TRUE(rig.ask(request::Rearm{}));
    run(Seconds(1.0));
    EXPECT_EQ(rig.control.state(), StationState::Standby);
    EXPECT_TRUE(isStill());
    EXPECT_THAT(alarmTexts(), HasSubstr("switch.pressed: The end switch at the upper end of the azimuth is pressed"));
    const Result<> onwards = rig.ask(request::Move{{.azimuth = 1_deg_s}});
    ASSERT_FALSE(onwards);
    EXPECT_EQ(
        onwards.error().text,
        QStringLiteral("The end switch at the upper end of the azimuth is pressed. Move the axis the other way."));
    const Angle before = azimuth();
    ASSERT_TRUE(rig.ask(request::Move{{.azimuth = -2_deg_s}}));
    run(Seconds(3.0));
    EXPECT_LT(azimuth(), before - 3_deg);
    EXPECT_EQ(rig.control.state(), StationState::Jog);
}

// REQ-ENDSWITCH-21: While a switch is pressed, every source is refused that would move the axis into this end: jog,
// go-to, park, client, tracking. The other axis and the way back are free.
TEST_F(StationEndSwitchTest, EverySourceIsRefused)
{
    ASSERT_TRUE(rig.point(100.0, 30.0, kOperator));
    run(Seconds(30.0));
    input(Axis::Azimuth, true).isOn = false;
    run(Seconds(0.5));
    const auto refuses = [this](const Request& request, const Source& by = kOperator) {
        const Result<> asked = rig.ask(request, by);
        EXPECT_FALSE(asked);
        EXPECT_THAT(asked ? std::string() : asked.error().text.toStdString(), HasSubstr("upper end of the azimuth"));
    };
    refuses(request::Move{{.azimuth = 1_deg_s}});
    refuses(request::PointSky{{.azimuth = 150_deg, .elevation = 40_deg}});
    refuses(request::PointAxes{{.azimuth = 150_deg, .elevation = 40_deg}});
    refuses(request::Track{targets::Target{.name = QStringLiteral("point"),
                                           .kind = SkyPointing{.azimuth = 150_deg, .elevation = 40_deg}}});
    const Permissions may = rig.control.status().permissions;
    EXPECT_FALSE(may.reason(jogAction(JogDirection::Right)).isEmpty());
    EXPECT_EQ(may.reason(jogAction(JogDirection::Left)), QString());
    EXPECT_EQ(may.reason(jogAction(JogDirection::Up)), QString());
    ASSERT_TRUE(rig.ask(request::GiveAuthority{}));
    refuses(request::PointSky{{.azimuth = 150_deg, .elevation = 40_deg}}, kClient);
    EXPECT_TRUE(rig.point(100.0, 50.0, kClient)) << "the other axis";
    run(Seconds(5.0));
    EXPECT_NEAR(rig.control.mount().measured()->elevation.degrees(), 50.0, 0.2);
    EXPECT_TRUE(rig.point(50.0, 50.0, kClient)) << "the way back";
    run(Seconds(10.0));
    EXPECT_NEAR(azimuth().degrees(), 50.0, 0.2);
}

// REQ-ENDSWITCH-66: An axis that meets its switch farther from the angle of the switch than the profile permits has
// lost steps: a fault, with an alarm that has both angles. The alarm stays after the re-arm, until the axis meets the
// switch where it is, or until a home run. A switch that is pressed while nothing moves is not compared.
TEST_F(StationEndSwitchTest, AnAxisThatMeetsItsSwitchElsewhereHasLostSteps)
{
    profile::Profile profile = switched();
    profile.endSwitches.places[1] = "40";
    profile.endSwitches.lostSteps = 3_deg;
    const auto before = *rig.inForce;
    rig.inForce.apply(profile);
    rig.control.profileChanged(before, *rig.inForce);
    run(Seconds(1.0));
    input(Axis::Azimuth, true).isOn = false;
    run(Seconds(1.0));
    EXPECT_THAT(alarmTexts(), testing::Not(HasSubstr("lost-steps"))) << "pressed by hand";
    read(true);
    run(Seconds(1.0));

    runInto();
    run(Seconds(0.6));
    EXPECT_EQ(rig.control.state(), StationState::Fault);
    EXPECT_TRUE(isStill());
    EXPECT_THAT(alarmTexts(), HasSubstr("switch.lost-steps: The mount met the end switch at the upper end of the "
                                        "azimuth at "));
    EXPECT_THAT(alarmTexts(), HasSubstr("but this switch is at 40.0°"));
    EXPECT_THAT(alarmTexts(), testing::Not(HasSubstr("switch.hit")));
    read(true);
    ASSERT_TRUE(rig.ask(request::Rearm{}));
    run(Seconds(1.0));
    EXPECT_THAT(alarmTexts(), HasSubstr("switch.lost-steps")) << "the angle is still wrong";

    ASSERT_TRUE(rig.point(39.0, 30.0, kOperator));
    run(Seconds(3.0));
    for (int i = 0; i < 1000 && azimuth() < 38_deg; ++i) {
        run(Seconds(0.02));
    }
    input(Axis::Azimuth, true).isOn = false;
    run(Seconds(1.0));
    EXPECT_THAT(alarmTexts(), testing::Not(HasSubstr("switch.lost-steps"))) << "it is where it should be";
}

// REQ-ENDSWITCH-22: Nothing moves by itself when the switch is released, also for a client that keeps sending its
// target.
TEST_F(StationEndSwitchTest, NothingMovesWhenItIsReleased)
{
    ASSERT_TRUE(rig.point(200.0, 30.0, kClient));
    run(Seconds(4.0));
    input(Axis::Azimuth, true).isOn = false;
    run(Seconds(2.0));
    ASSERT_EQ(rig.control.state(), StationState::Fault);
    read(true);
    for (int i = 0; i < 5; ++i) {
        EXPECT_FALSE(rig.point(200.0, 30.0, kClient));
        EXPECT_TRUE(isStill());
    }
    EXPECT_THAT(alarmTexts(), HasSubstr("switch.hit")) << "until the re-arm";
    ASSERT_TRUE(rig.ask(request::Rearm{}));
    run(Seconds(1.0));
    EXPECT_TRUE(isStill());
    EXPECT_EQ(alarmTexts(), "");
    EXPECT_TRUE(rig.point(200.0, 30.0, kOperator));
}

// REQ-ENDSWITCH-23: A switch that is pressed while nothing moves into its end is a warning and no fault.
TEST_F(StationEndSwitchTest, PressedByHandItIsNoFault)
{
    ASSERT_TRUE(rig.ask(request::Move{{.azimuth = 2_deg_s}}));
    run(Seconds(1.0));
    input(Axis::Azimuth, false).isOn = false;
    input(Axis::Elevation, true).isOn = false;
    run(Seconds(1.0));
    EXPECT_EQ(rig.control.state(), StationState::Jog) << "the mount moves the other way";
    EXPECT_THAT(alarmTexts(), HasSubstr("switch.pressed: The end switch at the lower end of the azimuth is pressed"));
    EXPECT_THAT(alarmTexts(), HasSubstr("the upper end of the elevation is pressed"));
    read(true);
    run(Seconds(1.0));
    EXPECT_EQ(alarmTexts(), "");
}

// REQ-ENDSWITCH-24: A switch that cannot be read raises an alarm and counts as pressed. The alarm names end, reason and
// input. An axis that moves into this end is stopped.
TEST_F(StationEndSwitchTest, UnreadItCountsAsPressed)
{
    ASSERT_TRUE(rig.ask(request::Move{{.azimuth = 2_deg_s}}));
    run(Seconds(1.0));
    input(Axis::Azimuth, true) = {.problem = QStringLiteral("no message for 5 s")};
    run(Seconds(1.5));
    EXPECT_EQ(rig.control.state(), StationState::Fault);
    EXPECT_TRUE(isStill());
    EXPECT_EQ(alarmTexts(),
              "switch.unread: The end switch at the upper end of the azimuth cannot be read: no message for 5 s.");
    ASSERT_TRUE(rig.ask(request::Rearm{}));
    run(Seconds(1.0));
    EXPECT_FALSE(rig.ask(request::Move{{.azimuth = 2_deg_s}}));
    EXPECT_TRUE(rig.ask(request::Move{{.azimuth = -2_deg_s}}));
    run(Seconds(1.0));
    read(true);
    run(Seconds(1.0));
    EXPECT_EQ(alarmTexts(), "");
}

// REQ-ENDSWITCH-25: If the profile says so, a switch that cannot be read is ignored. This is a warning.
TEST_F(StationEndSwitchTest, UnreadItIsIgnoredIfTheProfileSaysSo)
{
    rig.profile.endSwitches.whenUnread = profile::WhenUnread::Ignored;
    rig.setProfile(rig.profile);
    run(Seconds(1.0));
    ASSERT_TRUE(rig.ask(request::Move{{.azimuth = 2_deg_s}}));
    run(Seconds(1.0));
    input(Axis::Azimuth, true) = {.problem = QStringLiteral("no message for 5 s")};
    run(Seconds(1.0));
    EXPECT_EQ(rig.control.state(), StationState::Jog);
    EXPECT_THAT(alarmTexts(), HasSubstr("switch.ignored: The end switch at the upper end of the azimuth"));
}

// REQ-ENDSWITCH-26: Before the first reading nothing moves into the end. It is an alarm after 5 s.
TEST_F(StationEndSwitchTest, BeforeTheFirstReadingNothingMovesThere)
{
    rig.profile.endSwitches.silence = Seconds(7.0);
    rig.setProfile(rig.profile);
    readings = {};
    run(Seconds(4.0));
    EXPECT_EQ(alarmTexts(), "");
    EXPECT_FALSE(rig.ask(request::Move{{.azimuth = 2_deg_s}}));
    EXPECT_FALSE(rig.ask(request::Move{{.azimuth = -2_deg_s}}));
    run(Seconds(2.0));
    EXPECT_THAT(alarmTexts(), HasSubstr("cannot be read: no reading has come yet"));
}

// REQ-ENDSWITCH-27: A switch that closes its circuit when it is pressed reads on while it is pressed.
TEST_F(StationEndSwitchTest, ASwitchMayCloseItsCircuit)
{
    rig.profile.endSwitches.pressedWhen = profile::PressedWhen::On;
    rig.setProfile(rig.profile);
    run(Seconds(1.0));
    EXPECT_FALSE(rig.ask(request::Move{{.azimuth = 2_deg_s}}));
    read(false);
    run(Seconds(1.0));
    EXPECT_TRUE(rig.ask(request::Move{{.azimuth = 2_deg_s}}));
}

// REQ-ENDSWITCH-28: The status has each switch of the profile with its state. Without end switches there is none, and
// nothing is closed.
TEST_F(StationEndSwitchTest, AreInTheStatus)
{
    rig.profile.endSwitches.inputs = {"", "mqtt:b", "", ""};
    rig.setProfile(rig.profile);
    run(Seconds(1.0));
    StationStatus status = rig.control.status();
    ASSERT_EQ(status.endSwitches.size(), 1U);
    EXPECT_EQ(status.endSwitches[0].which, (end_switches::EndSwitch{Axis::Azimuth, true}));
    EXPECT_EQ(status.endSwitches[0].input, QStringLiteral("mqtt:b"));
    EXPECT_EQ(status.endSwitches[0].state, SwitchState::Free);
    EXPECT_FALSE(status.endSwitches[0].isClosed);
    read(false);
    run(Seconds(0.1));
    EXPECT_EQ(rig.control.status().endSwitches[0].state, SwitchState::Pressed);
    EXPECT_TRUE(rig.ask(request::Move{{.azimuth = -2_deg_s}})) << "there is no switch at this end";
    rig.profile.endSwitches.inputs = {};
    rig.setProfile(rig.profile);
    run(Seconds(0.1));
    EXPECT_TRUE(rig.control.status().endSwitches.empty());
    EXPECT_EQ(alarmTexts(), "");
    EXPECT_TRUE(rig.ask(request::Move{{.azimuth = 2_deg_s}}));
}

}  // namespace
}  // namespace boresight
