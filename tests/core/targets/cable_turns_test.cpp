// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/targets/cable_turns.h"

#include <gtest/gtest.h>

#include <vector>

namespace boresight::targets {
namespace {

const UtcTime kRise = std::chrono::sys_days(std::chrono::year(2026) / 12 / 24);

// A mount that turns at 10°/s and reaches this speed in 1 s. A full turn takes 37 s.
MountReach mount(const TravelRange& azimuths, const TravelRange& elevations = {0_deg, 90_deg})
{
    profile::Profile profile;
    profile.azimuth.geometry.travel = azimuths;
    profile.elevation.geometry.travel = elevations;
    profile.limits.azimuth = azimuths;
    profile.limits.elevation = elevations;
    return reachOf(profile, profile.antenna({}));
}

// One degree a second along one elevation, from one azimuth to another. It is hidden until `hiddenUntil`.
std::vector<SkyMoment> along(int from, int to, int hiddenUntil = 0, Angle elevation = 45_deg)
{
    std::vector<SkyMoment> way;
    const int step = from < to ? 1 : -1;
    for (int azimuth = from; azimuth != to + step; azimuth += step) {
        const std::chrono::seconds after(std::abs(azimuth - from));
        way.push_back({.utc = kRise + after,
                       .direction = {Angle::fromDegrees(azimuth).wrapped360(), elevation},
                       .isHidden = after < std::chrono::seconds(hiddenUntil)});
    }
    return way;
}

// REQ-TARGETS-930 (CableTurns.*): For each path it is known in advance whether one cable wrap has room for all of it,
// as the station chooses the wrap. If none has room, the mount unwraps by 360° on the way. Known are the number of such
// turns, the lost seconds outside the hidden parts, and whether elevations above 90° would avoid them.
TEST(CableTurns, NoneWhereAWrapHasRoom)
{
    EXPECT_EQ(cableTurns(along(340, 460), mount({-90_deg, 450_deg})), CableTurns());
    EXPECT_EQ(cableTurns(along(10, 350), mount({0_deg, 360_deg})), CableTurns());
    EXPECT_EQ(cableTurns(along(300, 60 + 360), mount({-180_deg, 180_deg})), CableTurns());
    EXPECT_EQ(cableTurns({}, mount({0_deg, 360_deg})), CableTurns());
}

// From north to north, or from south to south.
TEST(CableTurns, ThroughTheEndOfTheCableTheMountTurnsBackOnce)
{
    const CableTurns rightwards = cableTurns(along(340, 460), mount({0_deg, 360_deg}));
    EXPECT_EQ(rightwards.turns, 1);
    EXPECT_NEAR(rightwards.lost.count(), 37.0, 0.5);
    const CableTurns leftwards = cableTurns(along(100, -20), mount({0_deg, 360_deg}));
    EXPECT_EQ(leftwards.turns, 1);
    EXPECT_NEAR(leftwards.lost.count(), 20.0, 0.5) << "the satellite sets before the mount is there";
    EXPECT_EQ(cableTurns(along(100, 260), mount({-180_deg, 180_deg})).turns, 1);
}

TEST(CableTurns, WhatIsHiddenIsNotLost)
{
    const MountReach reach = mount({0_deg, 360_deg});
    const CableTurns found = cableTurns(along(340, 460, 40), reach);
    EXPECT_EQ(found.turns, 1);
    EXPECT_NEAR(found.lost.count(), 17.0, 0.5) << "the cable ends after 20 s, and the mount is back after 57";
    EXPECT_EQ(cableTurns(along(340, 460, 200), reach).lost, Seconds(0.0));
}

// The azimuths that this mount cannot reach are hidden anyway.
TEST(CableTurns, AGapOfTheTravelIsNotATurnMore)
{
    const MountReach reach = mount({10_deg, 350_deg});
    EXPECT_TRUE(cableTurns(along(300, 420), reach).hasGap);
    EXPECT_FALSE(cableTurns(along(340, 460), mount({0_deg, 360_deg})).hasGap);
    EXPECT_EQ(cableTurns(along(300, 420), reach).turns, 1);
    EXPECT_EQ(cableTurns(along(355, 460), reach).turns, 1) << "it rises in the gap, where the mount waits at an end";
}

TEST(CableTurns, OverTheTopTheCableHasRoom)
{
    EXPECT_TRUE(cableTurns(along(340, 460), mount({0_deg, 360_deg}, {0_deg, 180_deg})).fitsOverTheTop);
    EXPECT_TRUE(cableTurns(along(340, 460, 0, Angle::fromDegrees(-1e-5)), mount({0_deg, 360_deg}, {0_deg, 180_deg}))
                    .fitsOverTheTop)
        << "a pass begins at the horizon, give or take";
    EXPECT_FALSE(cableTurns(along(340, 460), mount({0_deg, 360_deg}, {0_deg, 90_deg})).fitsOverTheTop);
    EXPECT_FALSE(cableTurns(along(340, 460), mount({0_deg, 360_deg}, {0_deg, 120_deg})).fitsOverTheTop)
        << "135° is beyond";
    EXPECT_FALSE(cableTurns(along(170, 460), mount({0_deg, 360_deg}, {0_deg, 180_deg})).fitsOverTheTop)
        << "it goes from south through north to south";
    EXPECT_FALSE(cableTurns(along(10, 100), mount({0_deg, 360_deg}, {0_deg, 180_deg})).fitsOverTheTop)
        << "nothing has to be spared";
    EXPECT_FALSE(cableTurns(along(340, 460, 200), mount({0_deg, 360_deg}, {0_deg, 180_deg})).fitsOverTheTop)
        << "nothing is seen of it";
}

TEST(CableTurns, LimitsAndOffsetsCountAsTheyDoForTheMount)
{
    profile::Profile profile;
    profile.limits.azimuth = {0_deg, 360_deg};
    const MountReach limited = reachOf(profile, profile.antenna({}));
    EXPECT_EQ(cableTurns(along(340, 460), limited).turns, 1);
    profile.pointing.azimuthOffset = 30_deg;
    const MountReach turned = reachOf(profile, profile.antenna({}));
    EXPECT_FALSE(turned == limited);
    EXPECT_EQ(cableTurns(along(10, 50), limited).turns, 0);
    EXPECT_EQ(cableTurns(along(10, 50), turned).turns, 1) << "the cable ends 30° beside north";
}

TEST(CableTurns, AMountWithoutAzimuthHasNoCable)
{
    profile::Profile profile;
    profile.azimuth.driver = profile::AxisDriver::None;
    EXPECT_EQ(cableTurns(along(340, 460), reachOf(profile, profile.antenna({}))), CableTurns());
}

}  // namespace
}  // namespace boresight::targets
