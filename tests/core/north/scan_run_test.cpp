// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/north/scan_run.h"

#include "tests/fakes/text_of.h"

#include <gtest/gtest.h>

#include <cmath>

namespace boresight {
namespace {

constexpr SteadyTime kStart{std::chrono::hours(1)};

SteadyTime scanTime(double seconds)
{
    return kStart + std::chrono::duration_cast<SteadyTime::duration>(Seconds(seconds));
}

// REQ-NORTH-38d (ScanRun.*): A cross scan uses powers that are typed or received from a receiver. It uses no power from
// before the mount stood still and the receiver settled, and takes the median of the powers within a second. Its second
// line goes through the peak of the first. Silence, or a first line without a peak, ends the scan with the reason. A
// new scan starts without the results of the last one.
TEST(ScanRun, WhatCameBeforeItHadSettledIsNeverUsed)
{
    ScanRun scan(8_deg, kStart);
    scan.hear(-10.0, scanTime(0.5));
    scan.hear(-10.0, scanTime(3.9));
    EXPECT_FALSE(scan.heard(scanTime(60.0)));
    scan.hear(-60.0, scanTime(4.1));
    EXPECT_FALSE(scan.heard(scanTime(5.0))) << "more may come";
    EXPECT_EQ(scan.heard(scanTime(5.2)), -60.0);
    scan.give(-60.0, scanTime(5.2));
    EXPECT_FALSE(scan.heard(scanTime(60.0))) << "of the place before";
    scan.hear(-10.0, scanTime(9.0));
    EXPECT_FALSE(scan.heard(scanTime(60.0)));
}

TEST(ScanRun, AMountThatStillMovesHasNotSettled)
{
    ScanRun scan(8_deg, kStart);
    scan.moves(scanTime(6.0));
    EXPECT_FALSE(scan.wantsPower(scanTime(7.0)));
    scan.hear(-10.0, scanTime(7.0));
    EXPECT_FALSE(scan.heard(scanTime(9.0)));
    EXPECT_TRUE(scan.wantsPower(scanTime(7.5)));
    scan.hear(-60.0, scanTime(7.6));
    EXPECT_EQ(scan.heard(scanTime(8.7)), -60.0);
    scan.moves(scanTime(8.8));  // a gust moves the mount
    EXPECT_FALSE(scan.heard(scanTime(9.0)));
}

TEST(ScanRun, ASlipOfTheReceiverDoesNoHarm)
{
    ScanRun scan(8_deg, kStart);
    for (const double power : {-60.1, -60.0, -12.0, -59.9, -60.05}) {
        scan.hear(power, scanTime(5.0));
    }
    EXPECT_EQ(scan.heard(scanTime(6.1)), -60.0);
}

TEST(ScanRun, ItSaysWhatItWaitsFor)
{
    ScanRun scan(8_deg, kStart);
    EXPECT_TRUE(scan.obstacle(scanTime(123.0)).isEmpty());
    EXPECT_EQ(QStringLiteral("No power reading received."), scan.obstacle(scanTime(125.0)));
    scan.moves(scanTime(124.5));
    EXPECT_TRUE(scan.obstacle(scanTime(125.0)).isEmpty()) << "a slow mount may come from the other side of the sky";
    scan.moves(scanTime(600.5));
    EXPECT_EQ(QStringLiteral("The mount does not stand still."), scan.obstacle(scanTime(601.0)));
}

// If the second line missed the peak of a weak source by half a beam, it would see half the power and find nothing.
TEST(ScanRun, TheSecondLineGoesThroughThePeakOfTheFirst)
{
    ScanRun scan(8_deg, kStart);
    double now = 0.0;
    for (int place = 0; place < ScanRun::kPlaces; ++place) {
        now += 5.0;
        EXPECT_EQ(Angle{}, scan.offset().elevation);
        const double off = scan.offset().across.degrees() - 1.0;
        scan.give(-60.0 - 0.3 * off * off, scanTime(now));
    }
    EXPECT_NEAR(1.0, scan.offset().across.degrees(), 0.01);
    EXPECT_EQ(-4_deg, scan.offset().elevation);
    EXPECT_TRUE(scan.obstacle(scanTime(now)).isEmpty());
}

TEST(ScanRun, EndsAfterTheFirstLineIfThatHasNoPeak)
{
    ScanRun scan(8_deg, kStart);
    for (int place = 0; place < ScanRun::kPlaces; ++place) {
        EXPECT_TRUE(scan.obstacle(scanTime(5.0 * place)).isEmpty());
        scan.give(-60.0, scanTime(5.0 * (place + 1)));
    }
    EXPECT_TRUE(scan.obstacle(scanTime(45.0)).startsWith(QStringLiteral("across: The power changes by only 0.00 dB")));
}

TEST(ScanRun, OnTheWayBackNothingIsListenedTo)
{
    ScanRun scan(8_deg, kStart);
    double now = 0.0;
    for (int place = 0; place < 2 * ScanRun::kPlaces; ++place) {
        now += 5.0;
        ASSERT_TRUE(scan.wantsPower(scanTime(now)));
        const calibration::SkyOffset offset = scan.offset();
        const double off = std::hypot(offset.across.degrees() - 1.0, offset.elevation.degrees() + 0.5);
        scan.give(-60.0 - 0.3 * off * off, scanTime(now));
    }
    scan.hear(0.0, scanTime(now + 5.0));
    EXPECT_FALSE(scan.heard(scanTime(now + 10.0)));
    EXPECT_TRUE(scan.done(scanTime(now + 5.0)));
    const auto peak = scan.outcome({.azimuth = 100_deg, .elevation = 0_deg});
    ASSERT_TRUE(peak) << textOf(peak.error());
    EXPECT_NEAR(101.0, peak->peak.azimuth.degrees(), 0.01);
    EXPECT_NEAR(-0.5, peak->peak.elevation.degrees(), 0.01);
}

}  // namespace
}  // namespace boresight
