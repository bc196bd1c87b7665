// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the reports when the azimuth cable ends during tracking. The travel is -90…450°.
#include "tests/core/control/station_rig.h"

#include <QDateTime>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace boresight {
namespace {

class StationCable : public ::testing::Test
{
protected:
    explicit StationCable(const profile::Profile& profile = {}) : rig(profile) {}

    void standAt(Angle azimuth)
    {
        rig.run(Seconds(0.2));
        ASSERT_TRUE(rig.ask(request::PointAxes{{.azimuth = azimuth, .elevation = 30_deg}}));
        rig.settle();
        ASSERT_TRUE(rig.ask(request::GiveAuthority{}));
    }

    // A client sends one target a second along 30° of elevation, with azimuths counted beyond 360°. Returns the last
    // azimuth.
    double stream(
        double from, double perSecond, int seconds, const std::function<void()>& look = [] {})
    {
        for (int second = 0; second < seconds; ++second) {
            EXPECT_TRUE(rig.point(std::fmod(from + second * perSecond, 360.0), 30.0));
            rig.run(Seconds(1.0));
            look();
        }
        return from + (seconds - 1) * perSecond;
    }

    [[nodiscard]] std::vector<LogEntry> lines(LogKind kind, const QString& words) const
    {
        auto found = rig.log.since(0, EventLog::kCapacity);
        std::erase_if(found, [&](const LogEntry& line) { return line.kind != kind || !line.text.contains(words); });
        return found;
    }
    [[nodiscard]] std::vector<LogEntry> turnBacks() const
    {
        return lines(LogKind::MotionStart, QStringLiteral("unwraps the cable"));
    }
    [[nodiscard]] std::vector<LogEntry> longWays() const
    {
        return lines(LogKind::MotionStart, QStringLiteral("goes the long way"));
    }
    [[nodiscard]] std::string reason() const { return rig.control.status().stateReason.toStdString(); }
    [[nodiscard]] std::string headline() const
    {
        const auto alarms = rig.control.status().alarms;
        return alarms.empty() ? std::string() : alarms.front().what.toStdString();
    }

    // Difference between the time in the headline and the countdown of the bar.
    [[nodiscard]] double headlineOff() const
    {
        const StationStatus status = rig.control.status();
        const QTime told =
            QTime::fromString(status.alarms.front().what.section(QLatin1Char(' '), -1), QStringLiteral("HH:mm:ss'Z.'"));
        const std::chrono::sys_days day = std::chrono::floor<std::chrono::days>(status.utc);
        const double now = std::chrono::duration<double>(status.utc - day).count();
        return told.isValid() ? told.msecsSinceStartOfDay() / 1000.0 - now - status.cableEnd->in.count() : NAN;
    }

    StationRig rig;
};

constexpr const char* kTurnsBack =
    "unwraps the cable by 360° because the cable ends at axis 450.0°. The target is lost for about 37 s";
constexpr const char* kDetail = "unwraps the cable by 360°";

// Story: at the end of the cable the mount started to turn by 360°, and neither the log nor the screen gave a reason.
// REQ-CONTROL-31a: Unwrapping at the cable end is a separate motion in the log, with source and reason. While it lasts
// the screen shows it below the state. This holds for a go-to as well.
TEST_F(StationCable, ATurnBackIsToldWithWhoAndWhyForAsLongAsItLasts)
{
    standAt(440_deg);
    stream(440.0, 1.0, 11);
    EXPECT_TRUE(turnBacks().empty());
    EXPECT_EQ(reason(), "go to 90.00° 30.00°");
    EXPECT_TRUE(rig.point(91.0, 30.0));
    ASSERT_EQ(turnBacks().size(), 1U);
    EXPECT_EQ(turnBacks().front().text.toStdString(), kTurnsBack);
    EXPECT_EQ(turnBacks().front().source, kClient.name);
    rig.run(Seconds(1.0));

    double turning = 0.0;
    stream(452.0, 1.0, 45, [&] {
        const StationStatus status = rig.control.status();
        const bool there = std::abs(status.azimuth.commanded->degrees() - status.azimuth.target->degrees()) < 1.0;
        EXPECT_EQ(status.stateReason.toStdString() == kDetail, !there) << status.azimuth.commanded->degrees();
        turning += there ? 0.0 : 1.0;
    });
    EXPECT_GE(turning, 30.0);
    EXPECT_EQ(rig.state(), StationState::Track);
    EXPECT_EQ(turnBacks().size(), 1U) << "once, not with each point";
}

// The targets move faster than a satellite: no path is predicted, so no alarm came before the unwrapping either.
// REQ-CONTROL-31a
TEST_F(StationCable, ATurnBackAfterTargetsFasterThanASatelliteIsToldAlike)
{
    standAt(400_deg);
    stream(400.0, 5.0, 12);
    ASSERT_EQ(turnBacks().size(), 1U);
    EXPECT_EQ(turnBacks().front().text.toStdString(), kTurnsBack);
    EXPECT_EQ(rig.state(), StationState::Slew);
    EXPECT_EQ(reason(), kDetail);
}

TEST_F(StationCable, TheOtherEndTurnsItBackTheOtherWay)
{
    standAt(-80_deg);
    stream(280.0, -1.0, 15);
    ASSERT_EQ(turnBacks().size(), 1U);
    EXPECT_TRUE(turnBacks().front().text.startsWith(
        QStringLiteral("unwraps the cable by 360° because the cable ends at axis -90.0°")));
    EXPECT_EQ(reason(), kDetail);
    rig.run(Seconds(60.0));
    EXPECT_NE(reason(), kDetail);
    EXPECT_NEAR(rig.azimuthDegrees(), 266.0, 1.0);
}

// Story: the way from 90° to 270° was logged as "turns back by 180° because the cable ends at -90.0°".
TEST_F(StationCable, HalfATurnIsNoTurnBack)
{
    standAt(90_deg);
    ASSERT_TRUE(rig.point(270.0, 30.0, kOperator));
    EXPECT_TRUE(turnBacks().empty());
    rig.settle();
    EXPECT_NEAR(std::abs(rig.azimuthDegrees() - 90.0), 180.0, 0.01);
}

// REQ-CONTROL-31a
TEST_F(StationCable, WhatEndsTheTurnBackEndsItsWords)
{
    standAt(440_deg);
    stream(440.0, 1.0, 15);
    ASSERT_EQ(reason(), kDetail);
    ASSERT_TRUE(rig.ask(request::Hold{}));
    rig.tick();
    EXPECT_EQ(reason(), "");
    ASSERT_TRUE(rig.ask(request::Park{}));
    rig.tick();
    EXPECT_EQ(reason().substr(0, 4), "park");
}

// REQ-CONTROL-31a
TEST_F(StationCable, AGoToTheOtherWayRoundSaysWhy)
{
    standAt(400_deg);
    ASSERT_TRUE(rig.point(60.0, 30.0, kOperator));
    EXPECT_TRUE(turnBacks().empty()) << "420° is inside";
    rig.settle();
    ASSERT_TRUE(rig.point(120.0, 30.0, kOperator));
    ASSERT_EQ(longWays().size(), 1U);
    EXPECT_EQ(longWays().front().source, kOperator.name);
    EXPECT_EQ(longWays().front().text.toStdString(), "goes the long way, 300°, because the cable ends at axis 450.0°");
    EXPECT_EQ(reason(), "cable end, long way 300°");
    rig.settle();
    EXPECT_NEAR(rig.azimuthDegrees(), 120.0, 0.1);
    EXPECT_EQ(reason(), "go to 120.00° 30.00°");
}

// Story: a go-to from 0° to 230° was shown as "turns back 230°", but the axis had not been farther before.
// REQ-CONTROL-31a
TEST_F(StationCable, AFirstGoToTheOtherWayRoundDoesNotTurnBack)
{
    standAt(0_deg);
    ASSERT_TRUE(rig.point(230.0, 30.0, kOperator));
    EXPECT_TRUE(turnBacks().empty());
    ASSERT_EQ(longWays().size(), 1U);
    EXPECT_EQ(longWays().front().text.toStdString(), "goes the long way, 230°, because the cable ends at axis -90.0°");
    EXPECT_EQ(reason(), "cable end, long way 230°");
}

// REQ-CONTROL-31b: The operator may choose to wait at the cable end instead of unwrapping. The mount moves on as soon
// as the target is back in range. The choice ends with the motion, and clients keep control.
TEST_F(StationCable, TheOperatorMayHoldAtTheEnd)
{
    standAt(430_deg);
    stream(430.0, 1.0, 5);
    ASSERT_TRUE(rig.ask(request::HoldAtEnd{}));
    EXPECT_EQ(lines(LogKind::Event, QStringLiteral("chooses to hold at the cable end")).size(), 1U);
    stream(435.0, 1.0, 10);
    EXPECT_THAT(rig.control.status().alarms.front().action.toStdString(), ::testing::HasSubstr("will hold there"));
    stream(445.0, 1.0, 30);
    EXPECT_TRUE(turnBacks().empty());
    EXPECT_NEAR(rig.azimuthDegrees(), 450.0, 0.05);
    EXPECT_THAT(rig.control.status().limitedReason.toStdString(),
                ::testing::HasSubstr("the operator chose to hold there"));

    stream(474.0, -1.0, 40);
    EXPECT_TRUE(turnBacks().empty());
    EXPECT_NEAR(rig.azimuthDegrees(), 435.0, 1.5);
}

// Story: the operator chose to hold at the end. From then on no alarm offered to unwrap, and at the end the status did
// not show the end any more.
// REQ-CONTROL-31d: After the choice to hold, an alarm offers to unwrap, before the end and while the mount waits there.
// The status shows the end for as long as the mount waits. The alarm is the only one about it.
TEST_F(StationCable, TheChoiceToHoldCanBeChangedUntilTheTargetIsBack)
{
    standAt(430_deg);
    stream(430.0, 1.0, 5);
    ASSERT_TRUE(rig.ask(request::HoldAtEnd{}));
    stream(435.0, 1.0, 10);
    ASSERT_EQ(rig.control.status().alarms.size(), 1U);
    EXPECT_EQ(rig.control.status().alarms.front().name, QStringLiteral("cable.hold-chosen"));
    EXPECT_EQ(rig.control.status().alarms.front().help, AlarmHelp::Unwind);
    stream(445.0, 1.0, 10);
    stream(455.0, 1.0, 20, [&] {
        const StationStatus status = rig.control.status();
        ASSERT_TRUE(status.cableEnd);
        EXPECT_EQ(status.cableEnd->end, 450_deg);
        EXPECT_EQ(status.cableEnd->in, Seconds(0.0));
        ASSERT_TRUE(status.alarms.front().active);
        EXPECT_EQ(status.alarms.front().what, QStringLiteral("The azimuth is at its cable end (450.0°)."));
        EXPECT_EQ(status.alarms.front().help, AlarmHelp::Unwind);
        EXPECT_TRUE(std::ranges::none_of(
            status.alarms, [](const Alarm& one) { return one.active && one.name == QLatin1String("target.outside"); }));
    });
    EXPECT_FALSE(rig.ask(request::HoldAtEnd{})) << "it is chosen already";
    ASSERT_TRUE(rig.ask(request::Unwind{}));
    rig.settle();
    EXPECT_FALSE(rig.control.status().cableEnd);
    EXPECT_NEAR(rig.azimuthDegrees(), 90.0, 0.1);
    ASSERT_TRUE(rig.ask(request::GiveAuthority{}));
    stream(475.0, 1.0, 20);
    EXPECT_NEAR(rig.azimuthDegrees(), 134.0, 1.5);
}

class StationCableOfOneWrap : public StationCable
{
protected:
    StationCableOfOneWrap() : StationCable(narrow()) {}

    static profile::Profile narrow()
    {
        profile::Profile profile;
        profile.limits.azimuth = {200_deg, 450_deg};
        return profile;
    }
};

// REQ-CONTROL-31d
TEST_F(StationCableOfOneWrap, OnlyTheStatusShowsTheEnd)
{
    standAt(430_deg);
    stream(430.0, 1.0, 15);
    stream(445.0, 1.0, 30);
    const StationStatus status = rig.control.status();
    ASSERT_TRUE(status.cableEnd);
    EXPECT_EQ(status.cableEnd->end, 450_deg);
    const auto isActive = [&](const char* name) {
        return std::ranges::any_of(status.alarms,
                                   [&](const Alarm& one) { return one.active && one.name == QLatin1String(name); });
    };
    EXPECT_TRUE(isActive("target.outside"));
    EXPECT_FALSE(isActive("cable.held"));
}

// REQ-CONTROL-31b
TEST_F(StationCable, TheChoiceToHoldEndsWithTheMotion)
{
    standAt(430_deg);
    stream(430.0, 1.0, 5);
    ASSERT_TRUE(rig.ask(request::HoldAtEnd{}));
    ASSERT_TRUE(rig.ask(request::Hold{}, kClient));
    rig.run(Seconds(3.0));
    stream(435.0, 1.0, 20);
    EXPECT_EQ(turnBacks().size(), 1U);
}

// REQ-CONTROL-31b
TEST_F(StationCable, WithoutAnEndAheadThereIsNothingToChoose)
{
    standAt(100_deg);
    stream(100.0, 1.0, 5);
    EXPECT_FALSE(rig.ask(request::HoldAtEnd{}));
    standAt(430_deg);
    stream(430.0, 1.0, 5);
    EXPECT_FALSE(rig.ask(request::HoldAtEnd{}, kClient)) << "a client does not choose";
}

TEST_F(StationCable, UnwindingIsNoTurnBackByTheCable)
{
    standAt(425_deg);
    ASSERT_TRUE(rig.ask(request::Unwind{}));
    rig.run(Seconds(2.0));
    EXPECT_TRUE(turnBacks().empty());
    EXPECT_TRUE(reason().starts_with("unwrap the cable"));
}

// Story: the headline showed "ends in 38 s" until the end, and still after the end.
// REQ-CONTROL-31
TEST_F(StationCable, TheHeadlineTellsWhenAndStaysTrue)
{
    standAt(390_deg);
    stream(390.0, 1.0, 8);
    EXPECT_EQ(headline().substr(0, 50), "The azimuth reaches its cable end (450.0°) at 00:");
    stream(398.0, 1.0, 50, [&] { EXPECT_LT(std::abs(headlineOff()), 4.0); });
    EXPECT_LE(lines(LogKind::Alarm, QStringLiteral("Reaches its cable end (450.0°)")).size(), 3U);
}

// REQ-CONTROL-31
TEST_F(StationCable, AnEndThatComesLaterIsInTheHeadlineAndIsNoOtherAlarm)
{
    standAt(390_deg);
    const double last = stream(390.0, 1.0, 30);
    const auto before = lines(LogKind::Alarm, QStringLiteral("Reaches its cable end (450.0°)"));
    ASSERT_FALSE(before.empty());
    const std::uint64_t alarm = rig.control.status().alarms.front().id;
    stream(last + 0.5, 0.5, 10);
    stream(last + 5.5, 0.5, 30, [&] { EXPECT_LT(std::abs(headlineOff()), 4.0); });
    EXPECT_EQ(rig.control.status().alarms.front().id, alarm);
    EXPECT_EQ(lines(LogKind::Alarm, QStringLiteral("Reaches its cable end (450.0°)")).size(), before.size());
}

}  // namespace
}  // namespace boresight
