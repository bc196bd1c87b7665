// SPDX-License-Identifier: GPL-3.0-or-later
// The beam stays away from the Sun for every source of motion. A mount that stands still while the Sun passes stays
// where it is.
#include "core/ephemeris/almanac.h"
#include "core/ephemeris/refraction.h"
#include "core/guards/clock_trust.h"
#include "core/guards/sun_watch.h"
#include "core/units/angle_between.h"
#include "tests/core/control/station_rig.h"
#include "tests/fakes/text_of.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace boresight {
namespace {

constexpr Site kLisbon{.latitude = 38.757_deg, .longitude = -9.117_deg, .heightMetres = 80.0};
constexpr Angle kRadius = 10_deg;

profile::Profile sunny()
{
    profile::Profile profile;
    profile.site = {.known = true,
                    .latitude = kLisbon.latitude,
                    .longitude = kLisbon.longitude,
                    .heightMetres = kLisbon.heightMetres};
    profile.sun = {.keepAway = profile::KeepAway::On, .radius = kRadius};
    return profile;
}

// Lisbon at noon: the Sun stands in the south at 31° elevation, and its azimuth changes by 0.3° a minute.
struct SunRig : StationRig
{
    explicit SunRig(const profile::Profile& settings = sunny()) : StationRig(settings)
    {
        clock.stepUtc(std::chrono::hours(12));
        run(Seconds(0.2));
    }

    [[nodiscard]] SkyPointing sun() const
    {
        ephemeris::Almanac almanac(kLisbon);
        return ephemeris::apparent(almanac.place(ephemeris::Body::Sun, clock.utc()).direction,
                                   ephemeris::Refraction::Light);
    }
    [[nodiscard]] Angle distance() const { return angleBetween(sun(), *control.status().actual); }
    [[nodiscard]] bool warned() const
    {
        for (const Alarm& alarm : control.status().alarms) {
            if (alarm.active && alarm.what.startsWith(QStringLiteral("The beam is less than 10.0° from the Sun"))) {
                return true;
            }
        }
        return false;
    }
    [[nodiscard]] bool goesTo(double azimuthDegrees, double elevationDegrees)
    {
        const bool accepted = point(azimuthDegrees, elevationDegrees, kOperator).has_value();
        settle();
        return accepted;
    }
    // Lets this time pass without any request, one tick a second.
    void wait(Seconds time)
    {
        for (Seconds left = time; left > Seconds(0.0); left -= Seconds(1.0)) {
            clock.stepUtc(Seconds(0.98));
            tick();
        }
    }
};

// REQ-CONTROL-39 (StationSun.*): If the profile says so, the beam stays away from the Sun. A keep-out around the Sun is
// renewed every 20 s and holds for every motion. A mount that stands still while the Sun passes stays there, with an
// alarm. From inside the keep-out only the way out is allowed. If keep-away is switched on while the Sun is tracked,
// the mount holds.
TEST(StationSun, IsAKeepOutWhileItIsUp)
{
    SunRig rig;
    const auto keepOuts = rig.control.status().sunKeepOuts;
    ASSERT_EQ(keepOuts.size(), 1U);
    const pointing::KeepOut& keepOut = keepOuts.front();
    EXPECT_EQ(keepOut.name, "Sun");
    const double middle = (keepOut.azimuthFrom + keepOut.azimuthTo).degrees() / 2.0;
    EXPECT_NEAR(middle, rig.sun().azimuth.degrees(), 0.2);
    EXPECT_NEAR((keepOut.elevationMax - keepOut.elevationMin).degrees(), 20.4, 1e-6);
    rig.clock.stepUtc(std::chrono::hours(8));
    rig.tick();
    EXPECT_TRUE(rig.control.status().sunKeepOuts.empty()) << "at night";
}

TEST(StationSun, NobodyMovesIntoIt)
{
    SunRig rig;
    const SkyPointing sun = rig.sun();
    const auto answer = rig.ask(request::PointSky{sun});
    ASSERT_FALSE(answer);
    EXPECT_NE(textOf(answer.error()).find("lies in keep-out \"Sun\""), std::string::npos) << textOf(answer.error());
    ASSERT_TRUE(rig.goesTo(sun.azimuth.degrees() - 30.0, sun.elevation.degrees()));
    for (int i = 0; i < 100; ++i) {
        (void)rig.ask(request::Jog{{.azimuth = 6_deg_s}});
        rig.run(Seconds(0.2));
        EXPECT_GE(rig.distance(), kRadius);
    }
    EXPECT_LT(rig.distance(), kRadius + 1_deg) << "the jog stopped at the edge";
    EXPECT_FALSE(rig.warned());
}

// A client's satellite crosses the Sun: the beam goes around the Sun.
TEST(StationSun, AStreamIsLedAroundIt)
{
    SunRig rig;
    const SkyPointing sun = rig.sun();
    bool limited = false;
    for (double way = -40.0; way <= 40.0; way += 0.5) {
        ASSERT_TRUE(rig.point(sun.azimuth.degrees() + way, sun.elevation.degrees()));
        rig.run(Seconds(1.0));
        EXPECT_GE(rig.distance(), kRadius);
        limited = limited || rig.control.status().limited;
    }
    rig.settle();
    EXPECT_TRUE(limited);
    EXPECT_NEAR(rig.azimuthDegrees(), sun.azimuth.degrees() + 40.0, 0.01);
}

// A mount stands for two hours where the Sun will pass. It never moves, and an alarm reports the Sun while it is there.
TEST(StationSun, AMountThatStandsStaysAndIsTold)
{
    SunRig rig;
    const SkyPointing ahead = [&] {
        ephemeris::Almanac almanac(kLisbon);
        return almanac.place(ephemeris::Body::Sun, rig.clock.utc() + std::chrono::minutes(60)).direction;
    }();
    ASSERT_TRUE(rig.goesTo(ahead.azimuth.degrees(), ahead.elevation.degrees()));
    const AxisPosition place{*rig.control.status().azimuth.actual, *rig.control.status().elevation.actual};
    int told = 0;
    for (int minute = 0; minute < 120; ++minute) {
        rig.wait(Seconds(60.0));
        EXPECT_NEAR(rig.azimuthDegrees(), place.azimuth.degrees(), 0.001);
        EXPECT_NEAR(rig.elevationDegrees(), place.elevation.degrees(), 0.001);
        if (abs(rig.distance() - kRadius) > 0.3_deg) {
            EXPECT_EQ(rig.warned(), rig.distance() < kRadius) << "minute " << minute;
        }
        told += rig.warned() ? 1 : 0;
    }
    EXPECT_GT(told, 50);
    EXPECT_FALSE(rig.warned()) << "it has passed";
    EXPECT_EQ(rig.state(), StationState::Hold);
}

// A client has pointed the mount once to where the Sun will pass. The mount stays: this old target does not make it
// move aside.
TEST(StationSun, ATargetThatStandsIsGivenUp)
{
    SunRig rig;
    const SkyPointing sun = rig.sun();
    ASSERT_TRUE(rig.point(sun.azimuth.degrees() + 20.0, sun.elevation.degrees()));
    rig.settle();
    const Angle azimuth = *rig.control.status().azimuth.actual;
    rig.wait(Seconds(3600.0));
    EXPECT_TRUE(rig.warned());
    EXPECT_EQ(rig.control.status().azimuth.actual, azimuth);
}

TEST(StationSun, FromInsideOnlyTheWayOutIsOpen)
{
    profile::Profile off = sunny();
    off.sun.keepAway = profile::KeepAway::Off;
    SunRig rig(off);
    const SkyPointing sun = rig.sun();
    ASSERT_TRUE(rig.goesTo(sun.azimuth.degrees() - 5.0, sun.elevation.degrees()));
    EXPECT_FALSE(rig.warned());
    EXPECT_TRUE(rig.control.status().sunKeepOuts.empty());
    rig.profile = sunny();
    rig.setProfile(rig.profile);
    rig.run(Seconds(1.0));
    EXPECT_TRUE(rig.warned());
    const double before = rig.azimuthDegrees();
    for (int i = 0; i < 20; ++i) {
        (void)rig.ask(request::Jog{{.azimuth = 2_deg_s}});
        rig.run(Seconds(0.2));
    }
    EXPECT_NEAR(rig.azimuthDegrees(), before, 1e-6) << "towards it: held";
    ASSERT_TRUE(rig.goesTo(sun.azimuth.degrees() - 30.0, sun.elevation.degrees()));
    EXPECT_GT(rig.distance(), kRadius);
    EXPECT_FALSE(rig.warned());
}

// When the clock of the computer is set, the keep-out moves at once and does not wait for 20 s.
TEST(StationSun, IsFoundAnewWhenTheClockIsSet)
{
    SunRig rig;
    rig.clock.stepUtc(-std::chrono::hours(2));
    rig.tick();
    const auto keepOuts = rig.control.status().sunKeepOuts;
    ASSERT_EQ(keepOuts.size(), 1U);
    EXPECT_NEAR((keepOuts.front().azimuthFrom + keepOuts.front().azimuthTo).degrees() / 2.0,
                rig.sun().azimuth.degrees(), 0.2);
}

// A beam at the edge of the circle stays outside until the keep-out is renewed, at any time of the day.
// REQ-CONTROL-39 (SunWatch.*)
TEST(SunWatch, ServesUntilItIsRenewed)
{
    const profile::InForce profile(sunny());
    SunWatch watch(profile);
    fakes::ManualClock clock;
    ephemeris::Almanac almanac(kLisbon);
    const UtcTime day = std::chrono::sys_days{std::chrono::year{2026} / 6 / 21};
    for (std::chrono::minutes minute{6 * 60}; minute < std::chrono::minutes(18 * 60);
         minute += std::chrono::minutes(7)) {
        clock.setUtc(day + minute);
        ASSERT_TRUE(watch.update(clock));
        clock.advance(SunWatch::kRenewal - std::chrono::seconds(1));
        EXPECT_FALSE(watch.update(clock)) << "not yet";
        ASSERT_EQ(watch.keepOuts().size(), 1U);
        const pointing::KeepOut keepOut = watch.keepOuts().front();
        const SkyPointing later =
            ephemeris::apparent(almanac.place(ephemeris::Body::Sun, day + minute + SunWatch::kRenewal).direction,
                                ephemeris::Refraction::Light);
        for (const Angle azimuth : {keepOut.azimuthFrom, keepOut.azimuthTo}) {
            for (Angle elevation = keepOut.elevationMin; elevation < keepOut.elevationMax; elevation += 0.5_deg) {
                EXPECT_GT(angleBetween(later, {azimuth, elevation}), kRadius);
            }
        }
        EXPECT_GT(angleBetween(later, {later.azimuth, keepOut.elevationMin}), kRadius);
    }
}

// A computer without a clock battery starts at 1 January 2000. No time source confirms its clock.
struct DoubtedRig : StationRig
{
    explicit DoubtedRig(const profile::Profile& settings = sunny()) : StationRig(settings)
    {
        clock.setSynchronised(false);
        clock.setUtc(std::chrono::sys_days{std::chrono::year{2000} / 1 / 1});
        run(Seconds(0.2));
    }

    [[nodiscard]] bool alarmed() const
    {
        const std::vector<Alarm> alarms = control.status().alarms;
        return std::ranges::any_of(alarms, [](const Alarm& alarm) {
            return alarm.active && alarm.what.startsWith(QStringLiteral("The clock of this computer is not synchr"));
        });
    }
    void synchronise()
    {
        clock.setUtc(std::chrono::sys_days{std::chrono::year{2026} / 11 / 21} + std::chrono::hours(12));
        clock.setSynchronised(true);
        run(Seconds(0.2));
    }
    [[nodiscard]] std::string refusal(double azimuthDegrees, double elevationDegrees)
    {
        const auto answer = point(azimuthDegrees, elevationDegrees, kOperator);
        return answer ? "" : textOf(answer.error());
    }
};

// Story: with the clock at 1 January 2000 the beam went into the Sun without an alarm.
// REQ-CONTROL-39a (StationSunClock.*): While no time source confirms the clock, keep-away refuses every place that the
// Sun can have at this latitude. An alarm and the refusals name the clock. Inside this band only the operator moves the
// mount, by slow jog. When the clock is synchronised the band ends, and nothing that was refused starts by itself. A
// clock that was synchronised is trusted for 24 h more unless it is set. `sun.clock = "trusted"` trusts a computer
// without a time source. No date before 2026 is trusted.
TEST(StationSunClock, WithoutASynchronisedClockNothingMovesToWhereTheSunCanBe)
{
    DoubtedRig rig;
    EXPECT_TRUE(rig.alarmed());
    EXPECT_NE(rig.refusal(180.0, 31.0).find("Sun at any time: the clock is not synchronised"), std::string::npos);
    EXPECT_NE(rig.refusal(120.0, 5.0).find("the clock is not synchronised"), std::string::npos);
    EXPECT_EQ(rig.refusal(20.0, 40.0), "") << "in the north the Sun never stands";
    rig.settle();
    ASSERT_TRUE(rig.ask(request::GiveAuthority{}));
    ASSERT_TRUE(rig.point(80.0, 40.0)) << "a client is led to the edge";
    rig.settle();
    EXPECT_TRUE(rig.control.status().limited);
    EXPECT_GT(rig.azimuthDegrees(), 30.0);
    ephemeris::Almanac almanac(kLisbon);
    for (int hour = 0; hour < 366 * 24; ++hour) {
        const UtcTime when = std::chrono::sys_days{std::chrono::year{2026} / 1 / 1} + std::chrono::hours(hour);
        const SkyPointing sun = almanac.place(ephemeris::Body::Sun, when).direction;
        if (sun.elevation > -2_deg) {
            ASSERT_GE(angleBetween(sun, *rig.control.status().actual), kRadius) << "hour " << hour;
        }
    }
}

TEST(StationSunClock, AnySourceThatVouchesForItEndsTheDoubtAndNothingSetsOff)
{
    DoubtedRig rig;
    ASSERT_TRUE(rig.point(90.0, 60.0));
    rig.settle();
    ASSERT_TRUE(rig.control.status().limited);
    const AxisPosition place{*rig.control.status().azimuth.actual, *rig.control.status().elevation.actual};
    rig.synchronise();
    EXPECT_FALSE(rig.alarmed());
    EXPECT_EQ(rig.control.status().sunKeepOuts.size(), 1U);
    rig.run(Seconds(5.0));
    EXPECT_EQ(rig.state(), StationState::Hold);
    EXPECT_NEAR(rig.azimuthDegrees(), place.azimuth.degrees(), 0.01);
    EXPECT_NEAR(rig.elevationDegrees(), place.elevation.degrees(), 0.01);
    ASSERT_TRUE(rig.point(90.0, 60.0)) << "a new act";
    rig.settle();
    EXPECT_NEAR(rig.elevationDegrees(), 60.0, 0.01);
}

// A mount stands where the Sun may be. No way out is known to be safe, so the operator has to look at the mount.
TEST(StationSunClock, FromInsideTheOperatorJogsOutSlowly)
{
    profile::Profile off = sunny();
    off.sun.keepAway = profile::KeepAway::Off;
    DoubtedRig rig(off);
    EXPECT_FALSE(rig.alarmed()) << "by choice";
    ASSERT_TRUE(rig.point(180.0, 24.0, kOperator));
    rig.settle();
    rig.profile = sunny();
    rig.setProfile(rig.profile);
    rig.run(Seconds(0.2));
    EXPECT_NE(rig.refusal(20.0, 40.0).find("The clock of this computer is not synchronised"), std::string::npos);
    EXPECT_FALSE(rig.point(20.0, 40.0)) << "nor for a client";
    EXPECT_FALSE(rig.ask(request::Jog{{.elevation = -3_deg_s}})) << "too fast";
    for (int i = 0; i < 400; ++i) {
        ASSERT_TRUE(rig.ask(request::Jog{{.elevation = -1.0 * rig.profile.jog.unwind}}));
        rig.run(Seconds(0.2));
    }
    rig.settle();
    EXPECT_LT(rig.elevationDegrees(), 18.0) << "below the lowest Sun of the winter";
    EXPECT_EQ(rig.refusal(180.0, 2.0), "");
}

TEST(StationSunClock, WhatIsOnItsWayInTheBandEndsWhenTheClockComesToBeDoubted)
{
    SunRig rig;
    const double azimuth = rig.sun().azimuth.degrees();
    ASSERT_TRUE(rig.point(azimuth - 60.0, 30.0));
    rig.settle();
    ASSERT_TRUE(rig.point(azimuth - 20.0, 50.0));
    rig.run(Seconds(1.0));
    rig.clock.setSynchronised(false);
    rig.clock.stepUtc(Seconds(20.0));
    rig.run(Seconds(5.0));
    EXPECT_EQ(rig.state(), StationState::Hold);
    const double there = rig.azimuthDegrees();
    rig.run(Seconds(5.0));
    EXPECT_NEAR(rig.azimuthDegrees(), there, 1e-6);
    EXPECT_FALSE(rig.point(azimuth - 20.0, 50.0));
}

// Without a time source the operator may declare the clock to be right. A date before this program was written is
// refused.
TEST(StationSunClock, TheOperatorMayVouchForIt)
{
    profile::Profile trusting = sunny();
    trusting.sun.clock = profile::SunClock::Trusted;
    DoubtedRig rig(trusting);
    EXPECT_TRUE(rig.alarmed()) << "in the year 2000";
    rig.clock.setUtc(std::chrono::sys_days{std::chrono::year{2026} / 11 / 21} + std::chrono::hours(12));
    rig.run(Seconds(0.2));
    EXPECT_FALSE(rig.alarmed());
    EXPECT_EQ(rig.control.status().sunKeepOuts.size(), 1U);
}

// Story: a field station lost its network. Nine hours later, in mid-pass, the kernel reported the clock as not
// synchronised.
// REQ-CONTROL-39a (ClockTrust.*)
TEST(ClockTrust, OutlivesTheTimeSourceForADay)
{
    constexpr auto kNeeded = profile::SunClock::Synchronised;
    fakes::ManualClock clock;
    ClockTrust trust;
    clock.setSynchronised(false);
    EXPECT_FALSE(trust.update(clock, kNeeded));
    clock.setSynchronised(true);
    EXPECT_TRUE(trust.update(clock, kNeeded));
    clock.setSynchronised(false);
    clock.advance(ClockTrust::kKeeps);
    EXPECT_TRUE(trust.update(clock, kNeeded));
    clock.advance(Seconds(1.0));
    EXPECT_FALSE(trust.update(clock, kNeeded));
}

TEST(ClockTrust, EndsWhenAClockThatNothingVouchesForIsSet)
{
    constexpr auto kNeeded = profile::SunClock::Synchronised;
    fakes::ManualClock clock;
    ClockTrust trust;
    EXPECT_TRUE(trust.update(clock, kNeeded));
    clock.stepUtc(std::chrono::hours(2));
    EXPECT_TRUE(trust.update(clock, kNeeded)) << "its time source has set it";
    clock.setSynchronised(false);
    clock.stepUtc(Seconds(1.0));
    EXPECT_TRUE(trust.update(clock, kNeeded)) << "a leap second";
    clock.stepUtc(std::chrono::minutes(5));
    EXPECT_FALSE(trust.update(clock, kNeeded));
}

TEST(ClockTrust, NoSourceVouchesForATimeBeforeThisProgram)
{
    fakes::ManualClock clock;
    clock.setUtc(std::chrono::sys_days{std::chrono::year{2000} / 1 / 1});
    EXPECT_FALSE(ClockTrust().update(clock, profile::SunClock::Synchronised));
    EXPECT_FALSE(ClockTrust().update(clock, profile::SunClock::Trusted));
}

}  // namespace
}  // namespace boresight
