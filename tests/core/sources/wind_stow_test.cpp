// SPDX-License-Identifier: GPL-3.0-or-later
// The mount in a strong wind.
#include "core/sources/wind_stow.h"

#include "core/alarms/catalogue.h"
#include "tests/core/control/station_rig.h"
#include "tests/fakes/text_of.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <optional>

namespace boresight {
namespace {

using testing::HasSubstr;

profile::Profile withAnemometer()
{
    profile::Profile profile;
    profile.park = {.azimuth = 20_deg, .elevation = 10_deg};
    profile.wind.source = "udp:4541";
    profile.wind.calm = 1.0;
    profile.wind.overrideFor = 2.0;
    return profile;
}

class WindStowTest : public testing::Test
{
protected:
    explicit WindStowTest(const profile::Profile& profile = withAnemometer()) : rig(profile)
    {
        blow(5.0, Seconds(1.0));
    }

    // One reading each second; no reading if `speed` is empty.
    void blow(std::optional<double> speed, Seconds time)
    {
        for (int i = 0; i < static_cast<int>(time / rig.step); ++i) {
            if (speed && i % 50 == 0) {
                rig.control.takeWind(*speed);
            }
            rig.tick();
        }
    }
    void goUp()
    {
        ASSERT_TRUE(rig.ask(request::PointAxes{{.azimuth = 60_deg, .elevation = 40_deg}}));
        blow(5.0, Seconds(40.0));
        ASSERT_EQ(rig.state(), StationState::Hold);
    }
    [[nodiscard]] std::string refusal(const Request& request, const Source& by = kOperator)
    {
        const Result<> answer = rig.ask(request, by);
        return answer ? std::string() : textOf(answer.error());
    }
    [[nodiscard]] std::optional<Alarm> alarmOf(const char* name) const
    {
        const auto list = rig.alarms.list();
        const auto found = std::ranges::find_if(
            list, [name](const Alarm& one) { return one.active && one.name == QLatin1String(name); });
        return found == list.end() ? std::nullopt : std::optional(*found);
    }
    [[nodiscard]] bool isRaised(const char* name) const { return alarmOf(name).has_value(); }
    [[nodiscard]] bool isAt(double azimuth, double elevation) const
    {
        return std::abs(rig.azimuthDegrees() - azimuth) < 0.1 && std::abs(rig.elevationDegrees() - elevation) < 0.1;
    }

    StationRig rig;
};

const Request kGo = request::PointAxes{{.azimuth = 50_deg, .elevation = 30_deg}};

// REQ-WIND-20: In a strong wind the motion ends and the mount parks. An alarm gives the reason, with speed and limit.
TEST_F(WindStowTest, AStrongWindParksTheMount)
{
    goUp();
    ASSERT_TRUE(rig.point(120.0, 50.0, kOperator));
    blow(5.0, Seconds(2.0));
    ASSERT_EQ(rig.state(), StationState::Slew);
    blow(17.0, Seconds(4.0));
    EXPECT_EQ(rig.control.status().commander.name, QStringLiteral("wind"));
    const auto alarm = alarmOf("wind.parks");
    ASSERT_TRUE(alarm);
    EXPECT_EQ(alarm->what, QStringLiteral("The wind reached 17.0 m/s. The limit is 15.0 m/s."));
    EXPECT_EQ(alarm->action, QStringLiteral("The mount parks and stays parked. Boresight refuses every other motion."));
    EXPECT_EQ(alarm->help, AlarmHelp::OverrideWind);
    blow(17.0, Seconds(60.0));
    EXPECT_EQ(rig.state(), StationState::Parked);
    EXPECT_TRUE(isAt(20.0, 10.0));
}

// REQ-WIND-21: In a strong wind every motion but Park is refused, whoever requests it, with the reason. Motion is
// permitted again when the wind was below the lower limit for the calm time. Nothing moves by itself then, not even for
// a client that kept sending.
TEST_F(WindStowTest, NothingElseMovesUntilTheWindIsOver)
{
    goUp();
    ASSERT_TRUE(rig.ask(request::GiveAuthority{}));
    blow(17.0, Seconds(60.0));
    const std::string why = refusal(kGo);
    EXPECT_EQ(why,
              "The wind reached 17.0 m/s. The limit is 15.0 m/s. Only Park moves the mount until the wind stays below "
              "10.0 m/s for 1 min.");
    EXPECT_EQ(refusal(request::Jog{{.azimuth = 1_deg_s, .elevation = {}}}), why);
    EXPECT_EQ(refusal(request::PointSky{{.azimuth = 50_deg, .elevation = 30_deg}}, kClient), why);
    EXPECT_EQ(rig.control.status().permissions.reason(Action::Point).toStdString(), why);
    EXPECT_TRUE(rig.control.status().permissions.allows(Action::Park));
    for (int i = 0; i < 70; ++i) {
        blow(8.0, Seconds(1.0));
        (void)rig.point(120.0, 50.0);
    }
    EXPECT_EQ(rig.control.status().wind.obstacle, QString());
    EXPECT_FALSE(isRaised("wind.parks"));
    EXPECT_EQ(rig.state(), StationState::Parked);
    EXPECT_TRUE(isAt(20.0, 10.0)) << "a client goes on only after the operator has given control back";
    EXPECT_EQ(refusal(kGo), "");
    blow(8.0, Seconds(40.0));
    EXPECT_TRUE(isAt(50.0, 30.0));
}

// Story: the operator pressed Hand over in a strong wind. After the calm time a client moved the mount, and nobody had
// acted.
// REQ-WIND-21a: The operator cannot give control to the clients while the wind forbids motion. The refusal says when it
// is possible. The operator can while the wind is overridden.
TEST_F(WindStowTest, ControlIsNotGivenInAStrongWind)
{
    goUp();
    blow(20.0, Seconds(60.0));
    const std::string why =
        "The wind reached 20.0 m/s. The limit is 15.0 m/s. Hand over when the wind has stayed below "
        "10.0 m/s for 1 min.";
    EXPECT_EQ(refusal(request::GiveAuthority{}), why);
    EXPECT_EQ(refusal(request::GiveControl{.clientId = 1}), why);
    EXPECT_EQ(rig.control.status().permissions.reason(Action::GiveAuthority).toStdString(), why);
    for (int i = 0; i < 70; ++i) {
        blow(5.0, Seconds(1.0));
        (void)rig.point(120.0, 50.0);
    }
    EXPECT_EQ(rig.state(), StationState::Parked);
    EXPECT_EQ(refusal(request::GiveAuthority{}), "");
    EXPECT_TRUE(rig.point(120.0, 50.0));
    blow(20.0, Seconds(60.0));
    ASSERT_EQ(refusal(request::OverrideWind{}), "");
    EXPECT_EQ(refusal(request::GiveAuthority{}), "");
}

// Story: Unpark was accepted in a strong wind. The mount stood unparked, and the alarm asked to park it again.
// REQ-WIND-21b: A mount that is parked in a strong wind stays parked. Unpark is refused with the reason, whoever
// requests it, but S of a client is answered. STOP works. On its way to the park position the mount may be held.
TEST_F(WindStowTest, AParkedMountStaysParked)
{
    goUp();
    ASSERT_TRUE(rig.ask(request::GiveAuthority{}));
    blow(17.0, Seconds(4.0));
    ASSERT_EQ(rig.state(), StationState::Slew);
    EXPECT_TRUE(rig.control.status().permissions.allows(Action::Hold));
    EXPECT_EQ(refusal(request::Hold{}), "");
    ASSERT_EQ(refusal(request::Park{}), "");
    blow(17.0, Seconds(60.0));
    ASSERT_EQ(rig.state(), StationState::Parked);
    const std::string why =
        "The wind reached 17.0 m/s. The limit is 15.0 m/s. The mount stays parked until the wind stays below "
        "10.0 m/s for 1 min.";
    EXPECT_EQ(refusal(request::Hold{}), why);
    EXPECT_EQ(refusal(request::Hold{}, kClient), "") << "it stops a mount that stands, and nothing changes";
    EXPECT_EQ(rig.state(), StationState::Parked);
    EXPECT_EQ(rig.control.status().permissions.reason(Action::Hold).toStdString(), why);
    blow(17.0, Seconds(1.0));
    EXPECT_EQ(rig.state(), StationState::Parked);
    EXPECT_TRUE(isRaised("wind.parks"));
    EXPECT_EQ(refusal(request::Stop{}), "");
    EXPECT_EQ(rig.state(), StationState::Stopped);
}

// REQ-WIND-21b
TEST_F(WindStowTest, AMountIsUnparkedAfterTheWindOrAgainstIt)
{
    goUp();
    blow(17.0, Seconds(60.0));
    ASSERT_EQ(rig.state(), StationState::Parked);
    ASSERT_EQ(refusal(request::OverrideWind{}), "");
    EXPECT_EQ(refusal(request::Hold{}), "");
    blow(17.0, Seconds(1.0));
    EXPECT_EQ(rig.state(), StationState::Hold);
    ASSERT_EQ(refusal(request::Park{}), "");
    blow(5.0, Seconds(130.0));  // longer than the override and the calm time
    ASSERT_EQ(rig.state(), StationState::Parked);
    EXPECT_EQ(refusal(request::Hold{}), "");
    EXPECT_EQ(rig.state(), StationState::Hold);
}

// REQ-WIND-22: The profile may name a separate place for a strong wind. While the wind is strong, Park also goes there.
TEST_F(WindStowTest, AnOwnPlace)
{
    profile::Profile own = withAnemometer();
    own.wind.stowAt = profile::StowAt::Place;
    own.wind.place = {.azimuth = 5_deg, .elevation = 85_deg};
    rig.setProfile(own);
    goUp();
    blow(17.0, Seconds(60.0));
    EXPECT_EQ(rig.state(), StationState::Parked);
    EXPECT_TRUE(isAt(5.0, 85.0));
    EXPECT_EQ(refusal(request::Park{}), "");
    blow(17.0, Seconds(20.0));
    EXPECT_TRUE(isAt(5.0, 85.0));
    blow(8.0, Seconds(70.0));
    EXPECT_EQ(refusal(request::Park{}), "");
    blow(8.0, Seconds(60.0));
    EXPECT_TRUE(isAt(20.0, 10.0));
}

// REQ-WIND-23: STOP stops the mount on its way to the park position. The mount does not start again by itself, not even
// after the reset of STOP. An alarm offers Park now.
TEST_F(WindStowTest, AfterStopNothingStartsByItself)
{
    goUp();
    blow(17.0, Seconds(5.0));
    ASSERT_TRUE(rig.ask(request::Stop{}));
    blow(17.0, Seconds(10.0));
    EXPECT_EQ(rig.state(), StationState::Stopped);
    ASSERT_TRUE(isRaised("wind.not-parked"));
    EXPECT_EQ(alarmOf("wind.not-parked")->help, AlarmHelp::ParkNow);
    EXPECT_EQ(refusal(request::Park{}), "STOP is latched. Reset STOP first.");
    const double azimuth = rig.azimuthDegrees();
    ASSERT_TRUE(rig.ask(request::ResetStop{}));
    blow(17.0, Seconds(30.0));
    EXPECT_NEAR(rig.azimuthDegrees(), azimuth, 0.01);
    EXPECT_TRUE(isRaised("wind.not-parked"));
    EXPECT_NE(refusal(kGo), "");
    EXPECT_EQ(refusal(request::Park{}), "");
    blow(17.0, Seconds(60.0));
    EXPECT_EQ(rig.state(), StationState::Parked);
    EXPECT_TRUE(isRaised("wind.parks"));
}

// REQ-WIND-24: The wind does not start a mount that nobody has moved since the start or since a fault. The alarm offers
// Park now.
TEST_F(WindStowTest, AfterTheStartAndAFaultNothingStartsByItself)
{
    blow(17.0, Seconds(30.0));
    EXPECT_EQ(rig.state(), StationState::Standby);
    EXPECT_NEAR(rig.azimuthDegrees(), 0.0, 0.01);
    EXPECT_TRUE(isRaised("wind.not-parked"));
    blow(8.0, Seconds(70.0));
    EXPECT_FALSE(isRaised("wind.not-parked"));
    goUp();
    rig.azimuth.fault = 38;
    rig.azimuth.mode = moteus::Mode::Fault;
    blow(17.0, Seconds(10.0));
    EXPECT_EQ(rig.state(), StationState::Fault);
    EXPECT_TRUE(isRaised("wind.not-parked"));
    rig.azimuth.fault = 0;
    ASSERT_TRUE(rig.ask(request::Rearm{}));
    blow(17.0, Seconds(10.0));
    EXPECT_EQ(rig.state(), StationState::Standby);
    EXPECT_NEAR(rig.azimuthDegrees(), 60.0, 0.5);
}

// REQ-WIND-24
TEST_F(WindStowTest, OnAnUnknownWrapNothingStartsByItself)
{
    StationRig lost(withAnemometer(), {.trustFirstContact = false});
    lost.run(Seconds(1.0));
    for (int i = 0; i < 10; ++i) {
        lost.control.takeWind(17.0);
        lost.run(Seconds(1.0));
    }
    EXPECT_FALSE(lost.moving());
    EXPECT_FALSE(lost.control.status().wind.obstacle.isEmpty());
    EXPECT_FALSE(lost.control.status().permissions.allows(Action::Park));
    EXPECT_TRUE(lost.ask(request::OverrideWind{})) << "the cable may have to be brought where its wrap can be judged";
}

// REQ-WIND-25: The operator may move the mount in a strong wind for the time in the profile. The window shows this.
// Then the mount parks again. No client may do this.
TEST_F(WindStowTest, TheOperatorOverrides)
{
    EXPECT_EQ(refusal(request::OverrideWind{}), "The wind does not forbid any motion.");
    goUp();
    blow(17.0, Seconds(60.0));
    EXPECT_EQ(refusal(request::OverrideWind{}, kClient), "only the operator may do this");
    ASSERT_EQ(refusal(request::OverrideWind{}), "");
    EXPECT_THAT(rig.lastLog(), HasSubstr("lets the mount move in the wind until "));
    blow(17.0, Seconds(0.1));
    EXPECT_EQ(rig.state(), StationState::Parked) << "it moves nothing";
    const auto alarm = alarmOf("wind.overridden");
    ASSERT_TRUE(alarm);
    EXPECT_THAT(alarm->action.toStdString(), HasSubstr("Then the mount parks."));
    EXPECT_EQ(alarm->help, AlarmHelp::ParkNow);
    EXPECT_TRUE(rig.control.status().wind.overriddenUntil);
    ASSERT_EQ(refusal(kGo), "");
    blow(17.0, Seconds(60.0));
    EXPECT_TRUE(isAt(50.0, 30.0));
    blow(17.0, Seconds(120.0));
    EXPECT_EQ(rig.state(), StationState::Parked);
    EXPECT_TRUE(isRaised("wind.parks"));
    EXPECT_NE(refusal(kGo), "");
}

// REQ-WIND-26: If no reading arrives, an alarm is raised and the mount works on. With wind.when_silent = "stow" the
// mount parks.
TEST_F(WindStowTest, SilenceIsToldOrParks)
{
    goUp();
    blow(std::nullopt, Seconds(31.0));
    ASSERT_TRUE(isRaised("wind.silent"));
    EXPECT_EQ(rig.state(), StationState::Hold);
    EXPECT_TRUE(rig.control.status().wind.isSilent);
    EXPECT_EQ(refusal(kGo), "");
    blow(5.0, Seconds(30.0));
    EXPECT_FALSE(isRaised("wind.silent"));
    profile::Profile careful = withAnemometer();
    careful.wind.whenSilent = profile::WhenSilent::Stow;
    rig.setProfile(careful);
    blow(5.0, Seconds(5.0));
    blow(std::nullopt, Seconds(31.0));
    EXPECT_FALSE(isRaised("wind.silent"));
    ASSERT_TRUE(isRaised("wind.parks"));
    EXPECT_THAT(alarmOf("wind.parks")->what.toStdString(),
                HasSubstr("The wind is unknown. No reading has come since "));
    blow(std::nullopt, Seconds(60.0));
    EXPECT_EQ(rig.state(), StationState::Parked);
    const QString since = alarmOf("wind.parks")->what.section(QLatin1Char(' '), -1);
    blow(5.0, Seconds(10.0));
    EXPECT_EQ(alarmOf("wind.parks")->what,
              QStringLiteral("The wind was unknown. No reading came after %1.").arg(since.chopped(1)));
    blow(5.0, Seconds(60.0));
    EXPECT_FALSE(isRaised("wind.parks"));
}

// Story: in a storm the anemometer fell silent. One alarm said that the mount stays parked. The other alarm said that
// Boresight does not park the mount.
// REQ-WIND-26a: If the readings end in a strong wind, the alarm about the silence says that the mount stays parked,
// because the calm time needs readings.
TEST_F(WindStowTest, SilenceInAStrongWindIsNoContradiction)
{
    goUp();
    blow(20.0, Seconds(60.0));
    blow(std::nullopt, Seconds(31.0));
    ASSERT_TRUE(isRaised("wind.parks"));
    EXPECT_FALSE(isRaised("wind.silent"));
    ASSERT_TRUE(isRaised("wind.silent-while-strong"));
    EXPECT_EQ(alarmOf("wind.silent-while-strong")->action,
              QStringLiteral("The calm time needs readings. Without them the wind counts as strong, and a parked mount "
                             "stays parked."));
    blow(std::nullopt, Seconds(90.0));
    EXPECT_EQ(rig.state(), StationState::Parked);
    EXPECT_NE(refusal(kGo), "");
    blow(5.0, Seconds(70.0));
    EXPECT_FALSE(isRaised("wind.silent-while-strong"));
    EXPECT_EQ(refusal(kGo), "");
}

// REQ-WIND-26b: The alarm about the silence says since when no reading has come: since the last one, since the start,
// or since the profile changed. It has the reason if the source reports one.
TEST_F(WindStowTest, SilenceHasItsBeginningAndItsReason)
{
    StationRig never(withAnemometer());
    const auto what = [&] {
        const auto list = never.alarms.list();
        const auto found =
            std::ranges::find_if(list, [](const Alarm& one) { return one.name == QLatin1String("wind.silent"); });
        return found == list.end() ? std::string() : found->what.toStdString();
    };
    never.run(Seconds(31.0));
    EXPECT_THAT(what(), testing::MatchesRegex("The wind is unknown. No reading has come since the start at [0-9:]+Z."));
    never.control.takeWindTrouble(QStringLiteral("http://anemometer/wind: Connection refused"));
    never.run(Seconds(0.1));
    EXPECT_THAT(what(), HasSubstr("Z (http://anemometer/wind: Connection refused)."));
    profile::Profile changed = withAnemometer();
    changed.wind.calm = 2.0;
    never.setProfile(changed);
    never.run(Seconds(31.0));
    EXPECT_THAT(what(), HasSubstr("No reading has come since the change of the profile at "));
    blow(std::nullopt, Seconds(31.0));
    ASSERT_TRUE(isRaised("wind.silent"));
    EXPECT_THAT(alarmOf("wind.silent")->what.toStdString(),
                testing::MatchesRegex("The wind is unknown. No reading has come since [0-9:]+Z."));
}

// REQ-WIND-26
TEST_F(WindStowTest, AReadingFromBeforeASuspendIsOld)
{
    goUp();
    rig.clock.sleep(Seconds(3600.0));
    blow(std::nullopt, Seconds(0.1));
    EXPECT_TRUE(rig.control.status().wind.isSilent);
    EXPECT_GT(rig.control.status().wind.age, Seconds(3600.0));
    blow(5.0, Seconds(1.0));
    EXPECT_FALSE(rig.control.status().wind.isSilent);
}

// REQ-WIND-27: Without a source the wind forbids nothing, whatever the last reading was.
TEST_F(WindStowTest, WithoutASourceTheWindForbidsNothing)
{
    goUp();
    blow(17.0, Seconds(60.0));
    profile::Profile none = withAnemometer();
    none.wind.source.clear();
    rig.setProfile(none);
    blow(std::nullopt, Seconds(60.0));
    EXPECT_FALSE(isRaised("wind.parks"));
    EXPECT_FALSE(isRaised("wind.silent"));
    EXPECT_EQ(rig.control.status().wind.source, QString());
    EXPECT_EQ(refusal(kGo), "");
}

// REQ-WIND-20
TEST_F(WindStowTest, WhatCannotBeParkedStops)
{
    goUp();
    ASSERT_TRUE(rig.ask(request::PointAxes{{.azimuth = 120_deg, .elevation = 50_deg}}));
    blow(5.0, Seconds(2.0));
    profile::Profile unconfirmed = withAnemometer();
    unconfirmed.mount.directions = profile::Directions::Unconfirmed;
    rig.setProfile(unconfirmed);
    blow(17.0, Seconds(20.0));
    EXPECT_EQ(rig.state(), StationState::Hold);
    EXPECT_LT(rig.azimuthDegrees(), 119.0);
    EXPECT_TRUE(isRaised("wind.not-parked"));
}

}  // namespace
}  // namespace boresight
