// SPDX-License-Identifier: GPL-3.0-or-later
// A balloon reports its position, and the mount follows it.
#include "core/sources/position_follow.h"

#include "core/units/angle_between.h"
#include "tests/core/control/station_rig.h"
#include "tests/fakes/text_of.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <functional>

namespace boresight {
namespace {

using testing::HasSubstr;

const Site kField{.latitude = 38.757_deg, .longitude = -9.117_deg, .heightMetres = 80.0};

profile::Profile atTheField()
{
    profile::Profile profile;
    profile.site = {
        .known = true, .latitude = kField.latitude, .longitude = kField.longitude, .heightMetres = kField.heightMetres};
    profile.position = {.source = profile::PositionSource::Udp, .stale = Seconds(10.0), .fastest = 500.0};
    return profile;
}

class PositionFollowTest : public testing::Test
{
protected:
    PositionFollowTest() { rig.run(Seconds(0.2)); }

    // It rises at 5 m/s and drifts at 25 m/s to the north. It starts 12 km north and 15 km east of the mount.
    [[nodiscard]] Site balloon(Seconds time) const
    {
        return {.latitude = kField.latitude + Angle::fromDegrees((12'000.0 + 25.0 * time.count()) / 111'000.0),
                .longitude = kField.longitude + Angle::fromDegrees(15'000.0 / 86'700.0),
                .heightMetres = 3000.0 + 5.0 * time.count()};
    }
    [[nodiscard]] Seconds flown() const { return rig.clock.now() - m_launched; }
    [[nodiscard]] SkyPointing trueDirection() const
    {
        const orbit::Vector there = orbit::Observer(balloon(flown())).ground({}, 0.0);
        return orbit::Observer(kField).look({.position = there, .velocity = {}}).direction;
    }
    void report()
    {
        (void)rig.control.receive(position::PositionText{.site = balloon(flown()), .name = QStringLiteral("B1")});
    }
    // The balloon flies, with a report each second.
    void fly(
        Seconds time, const std::function<void()>& each = [] {})
    {
        for (int i = 0; i < static_cast<int>(time / rig.step); ++i) {
            if (isReporting && i % 50 == 0) {
                report();
            }
            rig.tick();
            each();
        }
    }
    std::string ask(const Source& by = kOperator)
    {
        const Result<> answer = rig.ask(request::FollowPosition{}, by);
        return answer ? std::string() : textOf(answer.error());
    }
    void follow()
    {
        fly(Seconds(3.0));
        ASSERT_EQ(ask(), "");
        fly(Seconds(40.0));
        ASSERT_LT(off(), 0.05_deg);
    }
    // Error of the measured beam.
    [[nodiscard]] Angle off() const
    {
        return angleBetween(rig.control.status().actual.value_or(SkyPointing{}), trueDirection());
    }
    [[nodiscard]] bool isRaised(const char* name) const
    {
        const auto list = rig.alarms.list();
        return std::ranges::any_of(list,
                                   [name](const Alarm& one) { return one.active && one.name == QLatin1String(name); });
    }

    StationRig rig{atTheField()};
    bool isReporting = true;

private:
    SteadyTime m_launched = rig.clock.now();
};

// REQ-POSITION-30: The mount follows an object that reports its position. Between two reports it continues the motion.
// With a report each second the beam is within 0.05° of a balloon 19 km away.
TEST_F(PositionFollowTest, KeepsTheBeamOnABalloon)
{
    follow();
    Angle worst;
    fly(Seconds(60.0), [&] { worst = std::max(worst, off()); });
    EXPECT_LT(worst, 0.05_deg);
    const StationStatus status = rig.control.status();
    EXPECT_EQ(status.state, StationState::Track);
    EXPECT_EQ(status.position.phase, PositionPhase::Following);
    EXPECT_EQ(status.tracked.value().name, QStringLiteral("B1"));
    EXPECT_TRUE(status.tracked.value().isUp);
    EXPECT_NEAR(status.position.kilometres.value(), 21.2, 0.3);
    EXPECT_EQ(status.targetText, QStringLiteral("track B1"));
}

// REQ-POSITION-31: Without a report for the time in the profile the mount stands still, with an alarm. For two minutes
// it resumes by itself if a report arrives. Then the tracking ends.
TEST_F(PositionFollowTest, StandsStillWithoutReports)
{
    follow();
    isReporting = false;
    fly(Seconds(10.5));
    EXPECT_TRUE(isRaised("position.stale"));
    EXPECT_EQ(rig.control.status().position.phase, PositionPhase::Stale);
    fly(Seconds(3.0));
    const auto place = rig.control.status().actual;
    fly(Seconds(30.0));
    EXPECT_LT(angleBetween(*place, *rig.control.status().actual), 0.02_deg);
    isReporting = true;
    fly(Seconds(30.0));
    EXPECT_FALSE(isRaised("position.stale"));
    EXPECT_LT(off(), 0.05_deg);
    isReporting = false;
    fly(Seconds(131.0));
    EXPECT_TRUE(isRaised("position.ended"));
    EXPECT_FALSE(isRaised("position.stale"));
    isReporting = true;
    fly(Seconds(5.0));
    EXPECT_EQ(rig.control.status().state, StationState::Hold);
    EXPECT_EQ(rig.control.status().position.phase, PositionPhase::Off);
    EXPECT_EQ(ask(), "");
    fly(Seconds(1.0));
    EXPECT_FALSE(isRaised("position.ended"));
}

// REQ-POSITION-34: If after a silence a report is more than 10° from the last direction, it may be a different object:
// the tracking ends with an alarm, and the mount holds.
TEST_F(PositionFollowTest, WhatComesBackElsewhereIsNotFollowed)
{
    follow();
    isReporting = false;
    fly(Seconds(14.0));
    ASSERT_TRUE(isRaised("position.stale"));
    const auto place = rig.control.status().actual;
    Site other = balloon(flown());
    other.longitude = kField.longitude;  // north of the mount
    EXPECT_TRUE(rig.control.receive(position::PositionText{.site = other}));
    fly(Seconds(5.0));
    EXPECT_LT(angleBetween(*place, *rig.control.status().actual), 0.02_deg);
    EXPECT_FALSE(isRaised("position.stale"));
    EXPECT_EQ(rig.control.status().position.phase, PositionPhase::Off);
    const auto list = rig.alarms.list();
    const auto ended = std::ranges::find(list, QStringLiteral("position.ended"), &Alarm::name);
    ASSERT_NE(ended, list.end());
    EXPECT_THAT(ended->what.toStdString(), HasSubstr("no longer tracked: the new position is "));
}

// REQ-POSITION-32: Following is refused without a report, without the site, while STOP is latched, and for a client.
// STOP, Hold, a jog and another target end it.
TEST_F(PositionFollowTest, PassesTheGatesOfAGoTo)
{
    EXPECT_EQ(ask(), "No position to track: no position was received");
    EXPECT_FALSE(rig.control.status().permissions.allows(Action::FollowPosition));
    fly(Seconds(1.0));
    EXPECT_TRUE(rig.control.status().permissions.allows(Action::FollowPosition));
    EXPECT_NE(ask(kClient), "");
    EXPECT_TRUE(rig.ask(request::Stop{}));
    fly(Seconds(1.0));
    EXPECT_THAT(ask(), HasSubstr("STOP is latched"));
    EXPECT_TRUE(rig.ask(request::ResetStop{}));
    for (const Request& other : {Request(request::Hold{}), Request(request::Stop{}),
                                 Request(request::PointSky{{.azimuth = 10_deg, .elevation = 20_deg}})}) {
        (void)rig.ask(request::ResetStop{});
        EXPECT_EQ(ask(), "");
        fly(Seconds(1.0));
        EXPECT_EQ(rig.control.status().position.phase, PositionPhase::Following);
        EXPECT_TRUE(rig.ask(other));
        fly(Seconds(8.0));
        EXPECT_EQ(rig.control.status().position.phase, PositionPhase::Off);
    }
    profile::Profile homeless = rig.profile;
    homeless.site.known = false;
    rig.setProfile(homeless);
    EXPECT_EQ(ask(), "No position to track: the site of the mount is not set");
}

// REQ-POSITION-35: Changing the source of the positions, or the rules for accepting them, drops the known position at
// once.
TEST_F(PositionFollowTest, AChangeOfTheProfileForgetsThePosition)
{
    const auto isForgottenBy = [this](const auto& change) {
        fly(Seconds(1.0));
        EXPECT_TRUE(rig.control.status().position.age);
        profile::Profile next = rig.profile;
        change(next.position);
        rig.setProfile(next);
        return !rig.control.status().position.age;
    };
    EXPECT_TRUE(isForgottenBy([](auto& position) { position.name = "B1"; }));
    EXPECT_TRUE(isForgottenBy([](auto& position) { position.stale = Seconds(20.0); }));
    EXPECT_TRUE(isForgottenBy([](auto& position) { position.port = 55'674; }));
    EXPECT_TRUE(isForgottenBy([](auto& position) { position.host = "0.0.0.0"; }));
    EXPECT_TRUE(isForgottenBy([](auto& position) { position.source = profile::PositionSource::Mqtt; }));
    EXPECT_TRUE(isForgottenBy([](auto& position) { position.topic = "sonde"; }));
    profile::Profile next = rig.profile;
    fly(Seconds(1.0));
    next.mount.name = "another";
    rig.setProfile(next);
    EXPECT_TRUE(rig.control.status().position.age);
}

// REQ-POSITION-33: A position that jumps or cannot be read moves nothing and is counted.
TEST_F(PositionFollowTest, AJumpMovesNothing)
{
    follow();
    Site far = balloon(flown());
    far.latitude = far.latitude - 1_deg;
    EXPECT_FALSE(rig.control.receive(position::PositionText{.site = far}));
    EXPECT_FALSE(rig.control.receive(position::readPosition("0,0,0")));
    fly(Seconds(5.0));
    EXPECT_LT(off(), 0.05_deg);
    EXPECT_EQ(rig.control.status().position.refused, 2U);
    EXPECT_THAT(rig.control.status().position.refusal.toStdString(), HasSubstr("GPS fix"));
}

// REQ-POSITION-42: The time of a report is judged by the clock of this computer, which the sending program reads, also
// while the mount is pointed by the old time.
TEST_F(PositionFollowTest, AReportIsJudgedByTheClockOfTheComputer)
{
    rig.clock.setAhead(Seconds(3600.0));
    const auto sent = [&](UtcTime utc) {
        const auto day = std::chrono::floor<std::chrono::days>(utc);
        return rig.control.receive(
            position::PositionText{.site = balloon(flown()),
                                   .name = QStringLiteral("B1"),
                                   .time = std::chrono::floor<std::chrono::milliseconds>(utc - day)});
    };
    EXPECT_FALSE(sent(rig.clock.utc()));
    EXPECT_TRUE(sent(rig.clock.computerUtc()));
    EXPECT_EQ(ask(), "");
}

}  // namespace
}  // namespace boresight
