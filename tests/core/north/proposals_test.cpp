// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/north/proposals.h"

#include "tests/core/north/north_rig.h"

#include <gtest/gtest.h>

namespace boresight {
namespace {

using namespace boresight::literals;

NewPoint proposedPoint()
{
    return {.axes = {.azimuth = 100_deg, .elevation = 30_deg},
            .truth = {.azimuth = 120_deg, .elevation = 30_deg},
            .sigma = 0.03_deg,
            .label = QStringLiteral("landmark")};
}

calibration::SensorOffset foundOffset()
{
    return {.offset = {.value = 37.4_deg, .sigma = 2_deg}, .statistical = 0.1_deg, .scatter = 0.5_deg, .used = 20};
}

void declinationIs(NorthRig& rig, Angle declination)
{
    SensorStatus status;
    status.declination = declination;
    EXPECT_EQ(nullptr, rig.sensor.take(status));
}

TEST(Proposals, WhatWasSeenIsWhatIsApplied)
{
    NorthRig rig;
    rig.proposals.propose(foundOffset());
    const std::uint64_t seen = rig.proposals.current()->number;
    EXPECT_TRUE(rig.proposals.isCurrent(seen));
    rig.proposals.propose(foundOffset());
    EXPECT_FALSE(rig.proposals.isCurrent(seen));
    EXPECT_FALSE(rig.proposals.discard(seen));
    ASSERT_TRUE(rig.proposals.discard(rig.proposals.current()->number));
    EXPECT_FALSE(rig.proposals.current());
}

TEST(Proposals, ADiscardedFitComesBackWithTheNextPoint)
{
    NorthRig rig;
    rig.points.add(proposedPoint());
    rig.proposals.pointsChanged();
    ASSERT_TRUE(rig.proposals.current());
    ASSERT_TRUE(rig.proposals.discard(rig.proposals.current()->number));
    rig.proposals.clear(Proposals::Next::Points);
    rig.proposals.profileChanged(false);
    EXPECT_FALSE(rig.proposals.current());
    rig.points.add(proposedPoint());
    rig.proposals.pointsChanged();
    EXPECT_TRUE(rig.proposals.current());
}

TEST(Proposals, PointsThatSayWhatIsInForceProposeNothing)
{
    NorthRig rig;
    rig.points.add(proposedPoint());
    rig.proposals.pointsChanged();
    ASSERT_TRUE(rig.proposals.current());
    EXPECT_TRUE(rig.proposals.isFound(calibration::Term::AzimuthOffset));
    rig.profile.pointing = rig.proposals.current()->terms;
    rig.inForce.apply(rig.profile);
    rig.points.fit();
    rig.proposals.profileChanged(false);
    EXPECT_FALSE(rig.proposals.current());
}

TEST(Proposals, AnOffsetIsStaleWithAnotherDeclination)
{
    NorthRig rig;
    declinationIs(rig, 5_deg);
    rig.proposals.propose(foundOffset());
    declinationIs(rig, 5.04_deg);
    rig.proposals.dropStale();
    EXPECT_TRUE(rig.proposals.current());
    EXPECT_TRUE(rig.proposals.ofSensor());
    declinationIs(rig, 5.1_deg);
    rig.proposals.dropStale();
    EXPECT_FALSE(rig.proposals.current());
    EXPECT_FALSE(rig.proposals.sensorOffset());
}

TEST(Proposals, AnOffsetIsStaleWithOtherSettingsOfTheSensor)
{
    NorthRig rig;
    rig.proposals.propose(foundOffset());
    rig.proposals.profileChanged(false);
    EXPECT_TRUE(rig.proposals.current());
    rig.proposals.profileChanged(true);
    EXPECT_FALSE(rig.proposals.current());
}

TEST(Proposals, TermsThatAreInForceAreNotProposed)
{
    NorthRig rig;
    rig.profile.pointing.azimuthOffset = 37.4_deg;
    rig.inForce.apply(rig.profile);
    EXPECT_FALSE(rig.proposals.propose({.title = QStringLiteral("Typed terms"), .terms = rig.profile.pointing}));
    pointing::PointingTerms typed = rig.profile.pointing;
    typed.collimation = 0.3_deg;
    ASSERT_TRUE(rig.proposals.propose({.title = QStringLiteral("Typed terms"), .terms = typed}));
    EXPECT_TRUE(rig.proposals.isFound(calibration::Term::Collimation));
    EXPECT_FALSE(rig.proposals.isFound(calibration::Term::AzimuthOffset));
    EXPECT_FALSE(rig.proposals.ofSensor());
}

}  // namespace
}  // namespace boresight
