// SPDX-License-Identifier: GPL-3.0-or-later
// A forbidden target is refused with its reason, or the mount goes to the nearest permitted place and shows that. This
// holds for every source.
#include "tests/core/control/station_rig.h"
#include "tests/fakes/text_of.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace boresight {
namespace {

pointing::KeepOut stationMast(Angle top = 40_deg)
{
    return {.name = "stationMast",
            .azimuthFrom = 300_deg,
            .azimuthTo = 330_deg,
            .elevationMin = 0_deg,
            .elevationMax = top};
}

// The region of scenario S15: a horizon of 25° all round except for one valley, and a keep-out in the north-west.
pointing::Region roof()
{
    return {.horizon = {{210_deg, 25_deg}, {214_deg, 0_deg}, {262_deg, 0_deg}, {266_deg, 25_deg}},
            .keepOuts = {stationMast()}};
}

profile::Profile profileWith(const pointing::Region& region)
{
    profile::Profile profile;
    profile.limits = region;
    return profile;
}

struct RegionRig : StationRig
{
    explicit RegionRig(const pointing::Region& region) : StationRig(profileWith(region)) { run(Seconds(0.2)); }

    // Runs until nothing moves. Once the set-points are permitted, they must stay permitted.
    void settlePermitted()
    {
        const pointing::PermittedRegion permitted(profile.limits, profile.azimuth.geometry.travel,
                                                  profile.elevation.geometry.travel);
        bool inside = false;
        for (int i = 0; i < 6000 && (i < 10 || moving()); ++i) {
            tick();
            const StationStatus status = control.status();
            if (status.azimuth.commanded && status.elevation.commanded) {
                const AxisPosition place{*status.azimuth.commanded, *status.elevation.commanded};
                EXPECT_TRUE(!inside || permitted.permits(place)) << permitted.reason(place).toStdString();
                inside = permitted.permits(place);
            }
        }
    }
    bool stands(const char* name) const { return !alarmText(name).empty(); }
    std::string alarmText(const char* name) const
    {
        for (const Alarm& alarm : control.status().alarms) {
            if (alarm.active && alarm.name == QLatin1String(name)) {
                return alarm.what.toStdString();
            }
        }
        return {};
    }
    bool logged(const QString& text) const
    {
        for (const LogEntry& line : log.since(0, 100000)) {
            if (line.text.contains(text)) {
                return true;
            }
        }
        return false;
    }
};

// REQ-AXES-25 (StationRegion.*)
// REQ-CONTROL-405 (StationRegion.*): Azimuths in refusals are directions from 0° to 360°, as people type them. Azimuths
// counted along the cable are marked as axis angles.
// REQ-AXES-26 (StationRegion.*): A forbidden target is refused with the reason and the nearest permitted place, or the
// mount goes to that place and shows AT LIMIT. If an obstacle is in the way to a permitted target, the mount goes
// around it, if necessary on another wrap, or refuses the target and names the obstacle.
TEST(StationRegion, TheOperatorIsRefusedAForbiddenPlaceAndToldTheNearest)
{
    RegionRig rig({.keepOuts = {stationMast()}});
    const auto answer = rig.point(315, 35, kOperator);
    ASSERT_FALSE(answer);
    EXPECT_EQ(answer.error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(textOf(answer.error()),
              "315.0° / 35.0° lies in keep-out \"stationMast\". Nearest allowed: 315.0° / 40.0°.");
    EXPECT_EQ(rig.commands(), 0U);
}

// REQ-CONTROL-920 (StationRegion.*): The window shows, before the operator sends the mount to a direction, whether it
// is allowed. The same checks as for the go-to decide: what shows as forbidden is refused, what shows as allowed is
// accepted.
TEST(StationRegion, ADirectionIsJudgedAsAGoToThereIsAnswered)
{
    pointing::Region region = roof();
    region.azimuth = {-60_deg, 250_deg};
    region.elevation = {5_deg, 85_deg};
    int forbidden = 0;
    int allowed = 0;
    for (int azimuth = 0; azimuth < 360; azimuth += 15) {
        for (const int elevation : {-5, 2, 12, 30, 60, 88, 95}) {
            RegionRig rig(region);
            const SkyPointing there{Angle::fromDegrees(azimuth), Angle::fromDegrees(elevation)};
            const QString whyNot = rig.control.judge(there).whyNot;
            EXPECT_EQ(whyNot.isEmpty(), rig.point(azimuth, elevation, kOperator).has_value())
                << azimuth << " " << elevation << " " << whyNot.toStdString();
            ++(whyNot.isEmpty() ? allowed : forbidden);
        }
    }
    EXPECT_GT(forbidden, 20);
    EXPECT_GT(allowed, 20);
}

// REQ-UI-712: For a direction that is not allowed the menu of the plot offers the nearest allowed direction, from 0° to
// 360°.
TEST(StationRegion, TheNearestAllowedDirectionIsOneThatIsAllowed)
{
    RegionRig rig(roof());
    EXPECT_EQ(rig.control.judge({20_deg, 60_deg}), DirectionVerdict{}) << "allowed itself";
    for (const SkyPointing& place : {SkyPointing{315_deg, 35_deg}, SkyPointing{180_deg, 20_deg}}) {
        const DirectionVerdict verdict = rig.control.judge(place);
        EXPECT_NE(verdict.whyNot, QString());
        ASSERT_TRUE(verdict.nearest);
        EXPECT_EQ(rig.control.judge(*verdict.nearest), DirectionVerdict{});
        EXPECT_GE(verdict.nearest->azimuth, 0_deg);
        EXPECT_LT(verdict.nearest->azimuth, 360_deg);
        EXPECT_LT(abs(verdict.nearest->elevation - place.elevation), 15_deg);
    }
    EXPECT_EQ(rig.control.judge({315_deg, 35_deg}).whyNot, QStringLiteral("the keep-out \"stationMast\""));
}

// A permitted place behind a wall from the horizon to the zenith. There is no nearer permitted place.
TEST(StationRegion, ADirectionWithoutAWayIsForbiddenAndHasNoOtherNearIt)
{
    pointing::Region region{.keepOuts = {stationMast(90_deg)}};
    region.azimuth = {-100_deg, 200_deg};
    RegionRig rig(region);
    const DirectionVerdict verdict = rig.control.judge({280_deg, 5_deg});
    EXPECT_TRUE(verdict.whyNot.contains(QStringLiteral("There is no way"))) << verdict.whyNot.toStdString();
    EXPECT_FALSE(verdict.nearest);
}

// REQ-CONTROL-934 (StationLimits.*): An antenna that stands where limits, horizon or a keep-out forbid it raises an
// alarm until it is out. The alarm starts no motion. Within half a degree of the edge there is no alarm.
TEST(StationLimits, AKeepOutDrawnOverTheAntennaIsAnAlarmUntilItIsOut)
{
    RegionRig rig({});
    ASSERT_TRUE(rig.ask(request::PointAxes{{.azimuth = 315_deg, .elevation = 39_deg}}));
    rig.settlePermitted();
    EXPECT_FALSE(rig.stands("limits.outside"));
    rig.draw({.keepOuts = {stationMast(42_deg)}});
    rig.run(Seconds(1.0));
    ASSERT_TRUE(rig.stands("limits.outside"));
    EXPECT_EQ(rig.alarmText("limits.outside"),
              "The antenna stands in a forbidden direction: the keep-out \"stationMast\".");
    EXPECT_FALSE(rig.moving());
    ASSERT_TRUE(rig.ask(request::PointAxes{{.azimuth = 315_deg, .elevation = 50_deg}}));
    rig.settlePermitted();
    EXPECT_FALSE(rig.stands("limits.outside"));
}

TEST(StationLimits, AtTheEdgeThereIsNoAlarm)
{
    RegionRig rig({});
    ASSERT_TRUE(rig.ask(request::PointAxes{{.azimuth = 315_deg, .elevation = 39.7_deg}}));
    rig.settlePermitted();
    rig.draw({.keepOuts = {stationMast(40_deg)}});
    rig.run(Seconds(1.0));
    EXPECT_FALSE(rig.stands("limits.outside"));
}

// REQ-CONTROL-922: Asking about a direction moves nothing, takes no control and leaves no line in the log.
TEST(StationRegion, AskingAboutADirectionChangesNothing)
{
    RegionRig rig(roof());
    const auto lines = rig.log.lastNumber();
    ASSERT_TRUE(rig.ask(request::JudgeDirection{{180_deg, 20_deg}}));
    EXPECT_FALSE(rig.ask(request::JudgeDirection{{180_deg, 20_deg}}, kClient));
    rig.run(Seconds(1.0));
    EXPECT_EQ(rig.commands(), 0U);
    EXPECT_EQ(rig.control.status().authority, Authority::Clients);
    EXPECT_EQ(rig.log.lastNumber(), lines);
}

// Story: the operator typed 315°, and the refusal named -45°.
TEST(StationRegion, ARefusalNamesTheAzimuthAsItIsTyped)
{
    RegionRig rig({.keepOuts = {stationMast(90_deg)}});
    ASSERT_TRUE(rig.ask(request::PointAxes{{.azimuth = -20_deg, .elevation = 5_deg}}));
    EXPECT_TRUE(rig.lastLog().starts_with("moves the mount from 0.00° 0.00°: go to axes -20.00° 5.00°"));
    rig.settlePermitted();
    const auto wall = rig.ask(request::PointAxes{{.azimuth = -80_deg, .elevation = 5_deg}});
    ASSERT_FALSE(wall);
    EXPECT_EQ(textOf(wall.error()),
              "There is no way from 340.0° 5.0° to 280.0° 5.0°. Between them is the keep-out \"stationMast\".");
    const auto beyond = rig.ask(request::PointAxes{{.azimuth = 451_deg, .elevation = 5_deg}});
    ASSERT_FALSE(beyond);
    EXPECT_EQ(textOf(beyond.error()), "azimuth axis 451.0° above limit 450.0°");
    ASSERT_TRUE(rig.ask(request::Step{.azimuth = 1_deg}));
    EXPECT_TRUE(rig.lastLog().starts_with("moves the mount from 340.00° 5.00°: step to 341.00° 5.00°"));
}

TEST(StationRegion, ParkingInAKeepOutIsRefused)
{
    profile::Profile profile = profileWith({.keepOuts = {stationMast()}});
    profile.park = {.azimuth = 315_deg, .elevation = 10_deg};
    StationRig rig(profile);
    rig.run(Seconds(0.2));
    const auto answer = rig.ask(request::Park{});
    ASSERT_FALSE(answer);
    EXPECT_NE(textOf(answer.error()).find("keep-out \"stationMast\""), std::string::npos);
}

TEST(StationRegion, AGoToIsDrivenAroundAndShowsItsRoute)
{
    RegionRig rig({.keepOuts = {stationMast()}});
    ASSERT_TRUE(rig.ask(request::PointAxes{{.azimuth = 290_deg, .elevation = 5_deg}}));
    rig.settlePermitted();
    ASSERT_TRUE(rig.ask(request::PointAxes{{.azimuth = 340_deg, .elevation = 5_deg}}));
    rig.tick();
    const StationStatus status = rig.control.status();
    ASSERT_FALSE(status.route.empty());
    EXPECT_EQ(status.route.front(), *status.commanded);
    EXPECT_NEAR(status.route.back().azimuth.degrees(), 340, 1e-9);
    EXPECT_NEAR(status.route.back().elevation.degrees(), 5, 1e-9);
    const SkyPointing highest = std::ranges::max(status.route, {}, &SkyPointing::elevation);
    EXPECT_NEAR(highest.elevation.degrees(), 40, 0.1) << "over the mast";
    rig.settlePermitted();
    EXPECT_EQ(rig.state(), StationState::Hold);
    EXPECT_NEAR(rig.azimuthDegrees(), 340, 0.001);
    EXPECT_TRUE(rig.control.status().route.empty());
}

TEST(StationRegion, ADirectionBehindAWallIsReachedByAnotherTurn)
{
    RegionRig rig({.keepOuts = {stationMast(90_deg)}});
    ASSERT_TRUE(rig.ask(request::PointAxes{{.azimuth = 290_deg, .elevation = 5_deg}}));
    rig.settlePermitted();
    ASSERT_TRUE(rig.point(340, 5, kOperator));
    rig.settlePermitted();
    EXPECT_NEAR(rig.azimuthDegrees(), -20, 0.001);
    const auto answer = rig.ask(request::PointAxes{{.azimuth = 340_deg, .elevation = 5_deg}});
    ASSERT_FALSE(answer);
    EXPECT_NE(textOf(answer.error()).find("Between them is the keep-out \"stationMast\""), std::string::npos);
}

TEST(StationRegion, AClientGetsTheNearestPermittedPlace)
{
    RegionRig rig(roof());
    ASSERT_TRUE(rig.point(240, 5));
    rig.settle();
    ASSERT_TRUE(rig.point(290, 5));
    rig.settlePermitted();
    const StationStatus status = rig.control.status();
    EXPECT_TRUE(status.limited);
    EXPECT_EQ(status.elevation.state, AxisState::Limit);
    EXPECT_EQ(status.elevation.stateText, QStringLiteral("at the horizon"));
    EXPECT_NEAR(status.target->elevation.degrees(), 5, 1e-9);
    EXPECT_TRUE(rig.logged(QStringLiteral("because of a limit (290.0° / 5.0° lies below the horizon (25.0°))")));
    ASSERT_TRUE(rig.point(240, 5));
    rig.settlePermitted();
    EXPECT_FALSE(rig.control.status().limited);
    EXPECT_NEAR(rig.elevationDegrees(), 5, 0.001);
}

// REQ-CONTROL-10
TEST(StationRegion, AClientIsRefusedWhereTheProfileSaysSo)
{
    profile::Profile profile = profileWith(roof());
    profile.rotctld.outsideLimits = profile::OutsideLimits::Refuse;
    StationRig rig(profile);
    rig.run(Seconds(0.2));
    EXPECT_FALSE(rig.point(315, 30));
    EXPECT_TRUE(rig.point(315, 41));
}

TEST(StationRegion, AHeldJogStopsAtTheEdgeSaysSoAndIsLetBack)
{
    RegionRig rig({.keepOuts = {stationMast()}});
    ASSERT_TRUE(rig.ask(request::PointAxes{{.azimuth = 295_deg, .elevation = 5_deg}}));
    rig.settlePermitted();
    const auto jog = [&rig](AngularRate rate) {
        for (int i = 0; i < 60; ++i) {
            ASSERT_TRUE(rig.ask(request::Jog{{.azimuth = rate}}));
            rig.run(Seconds(0.2));
        }
    };
    jog(6_deg_s);
    EXPECT_NEAR(rig.azimuthDegrees(), 300, 0.001);
    const StationStatus status = rig.control.status();
    EXPECT_EQ(status.azimuth.state, AxisState::Limit);
    EXPECT_EQ(status.azimuth.stateText, QStringLiteral("at the keep-out \"stationMast\""));
    EXPECT_TRUE(rig.logged(QStringLiteral("held at the keep-out \"stationMast\"")));
    jog(-1_deg_s);
    EXPECT_LT(rig.azimuthDegrees(), 297);
}

TEST(StationRegion, TheHorizonIsAsLowAsItGoes)
{
    RegionRig rig(roof());
    ASSERT_TRUE(rig.ask(request::PointAxes{{.azimuth = 240_deg, .elevation = 50_deg}}));
    rig.settlePermitted();
    ASSERT_TRUE(rig.ask(request::Horizon{}));
    rig.settlePermitted();
    EXPECT_NEAR(rig.elevationDegrees(), 0, 0.001);
    ASSERT_TRUE(rig.ask(request::PointAxes{{.azimuth = 315_deg, .elevation = 50_deg}}));
    rig.settlePermitted();
    ASSERT_TRUE(rig.ask(request::Horizon{}));
    rig.settlePermitted();
    EXPECT_NEAR(rig.elevationDegrees(), 40, 0.001);
}

TEST(StationRegion, LimitsOfOperationChooseTheTurnAndEndTheJog)
{
    RegionRig rig({.azimuth = {-30_deg, 200_deg}, .elevation = {10_deg, 60_deg}});
    ASSERT_TRUE(rig.ask(request::Home{}));
    rig.settlePermitted();
    EXPECT_NEAR(rig.elevationDegrees(), 10, 0.001);
    EXPECT_FALSE(rig.point(100, 70, kOperator));
    EXPECT_FALSE(rig.point(250, 20, kOperator));
    ASSERT_TRUE(rig.point(190, 20, kOperator));
    rig.settlePermitted();
    EXPECT_NEAR(rig.azimuthDegrees(), 190, 0.001);
}

TEST(StationRegion, DrawnOntoTheMountItHoldsAndOnlyLetsOut)
{
    RegionRig rig({});
    ASSERT_TRUE(rig.ask(request::PointAxes{{.azimuth = 310_deg, .elevation = 38_deg}}));
    rig.settle();
    rig.draw({.keepOuts = {stationMast()}});
    rig.run(Seconds(2.0));
    EXPECT_NEAR(rig.elevationDegrees(), 38, 0.001) << "it does not move by itself";
    for (int i = 0; i < 10; ++i) {
        ASSERT_TRUE(rig.ask(request::Jog{{.azimuth = 2_deg_s, .elevation = -2_deg_s}}));
        rig.run(Seconds(0.2));
    }
    EXPECT_NEAR(rig.elevationDegrees(), 38, 0.001);
    EXPECT_NEAR(rig.azimuthDegrees(), 310, 0.001);
    ASSERT_TRUE(rig.ask(request::PointAxes{{.azimuth = 340_deg, .elevation = 5_deg}}));
    rig.settle();
    EXPECT_NEAR(rig.azimuthDegrees(), 340, 0.001);
}

TEST(StationRegion, AnEdgeDrawnAcrossAGoToEndsItWithTheReason)
{
    RegionRig rig({});
    ASSERT_TRUE(rig.ask(request::PointAxes{{.azimuth = 290_deg, .elevation = 5_deg}}));
    rig.settle();
    ASSERT_TRUE(rig.ask(request::PointAxes{{.azimuth = 400_deg, .elevation = 5_deg}}));
    rig.tick();
    rig.draw({.keepOuts = {stationMast(90_deg)}});
    rig.run(Seconds(3.0));
    EXPECT_EQ(rig.state(), StationState::Hold);
    EXPECT_LT(rig.azimuthDegrees(), 300.001);
    EXPECT_TRUE(rig.logged(QStringLiteral("ends the motion: There is no way from")));
}

}  // namespace
}  // namespace boresight
