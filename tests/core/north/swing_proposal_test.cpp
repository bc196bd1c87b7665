// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the proposal of a swing for the zero of elevation, which a tilted sensor box falsifies, too. Also tests how a
// swing treats a north and a tilt that points have determined better.
#include "core/north/calibration_proposal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace boresight {
namespace {

using namespace boresight::literals;
using calibration::indexOf;
using calibration::Term;

// The sensor reports this angle where the elevation axis shows 0°.
SwingOutcome saying(Angle zero)
{
    calibration::AxisTilt tilt;
    tilt.elevationOffset = {zero, 1_deg};
    tilt.sizeSigma = 0.05_deg;
    SwingOutcome swing;
    swing.fit.north = {37.4_deg, 1.6_deg};
    swing.tilt = tilt;
    return swing;
}

Angle sensorZero(const Proposal& proposal)
{
    return proposal.sensor->elevationOffset;
}

bool warns(const Proposal& proposal)
{
    return std::ranges::any_of(proposal.warnings, [](const QString& warning) {
        return warning.contains(QStringLiteral("zero")) || warning.contains(QStringLiteral("differ"));
    });
}

// REQ-NORTH-36b (SwingProposal.*): The zero of elevation that the sensor reports is attributed to the sensor box as far
// as the box may be tilted, and beyond that to the axis. A north and a tilt that points have found better stay, and
// Apply takes the curve only, unless the compass contradicts them. A term that the points only held belongs to the
// earlier swing, and the result of the next swing is equally good.
TEST(SwingProposal, WhatABoxAskewExplainsIsTheSensors)
{
    profile::Profile profile;
    profile.pointing.elevationOffset = -0.25_deg;
    const Proposal proposal = proposalOf(saying(0.7_deg), profile);
    EXPECT_EQ(-0.25_deg, proposal.terms.elevationOffset) << "the beam stays";
    EXPECT_FALSE(proposal.sigmas[indexOf(Term::ElevationOffset)]);
    EXPECT_NEAR(-0.95, sensorZero(proposal).degrees(), 1e-9) << "0.70° as sent are -0.25° of the beam then";
    EXPECT_FALSE(warns(proposal));
    EXPECT_TRUE(proposal.text.contains(QStringLiteral("tilted sensor")));
}

TEST(SwingProposal, MoreThanThatIsTheZeroOfTheAxis)
{
    profile::Profile profile;
    profile.sensor.mounting.elevationOffset = 1_deg;
    const Proposal proposal = proposalOf(saying(3_deg), profile);
    EXPECT_NEAR(4.0, proposal.terms.elevationOffset.degrees(), 1e-9);
    EXPECT_EQ(1_deg, *proposal.sigmas[indexOf(Term::ElevationOffset)]);
    EXPECT_EQ(1_deg, sensorZero(proposal)) << "as it was mounted";
    EXPECT_TRUE(warns(proposal));
}

TEST(SwingProposal, AZeroThatTheSunHasToldStays)
{
    profile::Profile profile;
    profile.pointing.elevationOffset = 0.4_deg;
    TermSigmas told;
    told[indexOf(Term::ElevationOffset)] = 0.03_deg;
    const Proposal proposal = proposalOf(saying(5_deg), profile, told);
    EXPECT_EQ(0.4_deg, proposal.terms.elevationOffset);
    EXPECT_NEAR(-4.6, sensorZero(proposal).degrees(), 1e-9);
    told[indexOf(Term::ElevationOffset)] = 2_deg;
    EXPECT_NEAR(5.0, proposalOf(saying(5_deg), profile, told).terms.elevationOffset.degrees(), 1e-9)
        << "known worse than the swing tells it";
}

// 6° in the profile and 7° from the swing make 13°, more than a profile accepts. The whole swing was refused because of
// it.
TEST(SwingProposal, AZeroBeyondWhatAProfileKeepsIsNotProposed)
{
    profile::Profile profile;
    profile.pointing.elevationOffset = 6_deg;
    const Proposal proposal = proposalOf(saying(13_deg), profile);
    EXPECT_EQ(6_deg, proposal.terms.elevationOffset);
    EXPECT_FALSE(proposal.sigmas[indexOf(Term::ElevationOffset)]);
    EXPECT_TRUE(proposal.text.contains(QStringLiteral("too much to correct")));
    EXPECT_TRUE(warns(proposal));
    EXPECT_TRUE(asSettings(proposal.terms)) << "north and curve can be applied";
    EXPECT_NEAR(37.4, proposal.terms.azimuthOffset.degrees(), 1e-9);
    // A small tilt is still attributed to the box, also near this limit.
    profile.pointing.elevationOffset = 9.5_deg;
    EXPECT_TRUE(proposalOf(saying(10.5_deg), profile).text.contains(QStringLiteral("tilted sensor")));
}

TEST(SwingProposal, WhatCannotBeAnOffsetIsPutRightByHand)
{
    const profile::Profile profile;
    const Proposal proposal = proposalOf(saying(60_deg), profile);
    EXPECT_EQ(0_deg, proposal.terms.elevationOffset);
    EXPECT_EQ(0_deg, sensorZero(proposal));
    EXPECT_TRUE(warns(proposal));
}

// North, tilt and deviation as the compass reports them.
SwingOutcome swung(Angle north, Angle tiltNorth = {})
{
    SwingOutcome swing = saying({});
    swing.fit.north = {north, 2.4_deg};
    swing.fit.statistical = 0.03_deg;
    swing.fit.curve.a1 = 8_deg;
    swing.fit.curve.constantSigma = 2.4_deg;
    swing.tilt->north = {tiltNorth, 0.05_deg};
    swing.tilt->size = abs(tiltNorth);
    return swing;
}

// A profile with the north from the Sun.
profile::Profile withNorth(Angle north)
{
    profile::Profile profile;
    profile.pointing.azimuthOffset = north;
    return profile;
}

TermSigmas northTold(Angle sigma)
{
    TermSigmas told;
    told[indexOf(Term::AzimuthOffset)] = sigma;
    return told;
}

// Story: 37.50° ± 0.11° from ten points was in effect. The swing proposed 37.63° ± 2.39°, and the curve could not be
// applied without it.
TEST(SwingProposal, ANorthThatPointsHaveToldBetterStays)
{
    const profile::Profile profile = withNorth(37.5_deg);
    const Proposal proposal = proposalOf(swung(39.5_deg), profile, northTold(0.11_deg));
    EXPECT_EQ(profile.pointing, proposal.terms);
    EXPECT_FALSE(proposal.sigmas[indexOf(Term::AzimuthOffset)]) << "of it nothing was found out";
    EXPECT_EQ(QStringLiteral("North stays unchanged. It is known to 0.11°, by compass only to 2.4°."), proposal.stays);
    EXPECT_EQ(QStringLiteral("Curve of the compass"), proposal.title);
    EXPECT_TRUE(proposal.warnings.empty()) << proposal.warnings.front().toStdString();
    // The swing took true azimuth as axis + 39.5°. In truth it is axis + 37.5°.
    const calibration::DeviationCurve asSwung{.a1 = 8_deg};
    const calibration::DeviationCurve& curve = *proposal.sensor->curve;
    for (const Angle axis : {0_deg, 70_deg, 200_deg}) {
        EXPECT_NEAR(asSwung.reading(axis + 39.5_deg).angle().degrees(),
                    curve.reading(axis + 37.5_deg).angle().degrees(), 1e-9);
    }
    EXPECT_EQ(-curve.constant, proposal.sensor->azimuthOffset);
    EXPECT_NEAR(std::hypot(0.11, 0.03), curve.constantSigma->degrees(), 1e-9);
}

TEST(SwingProposal, ANorthThatNobodyHasToldBetterIsReplaced)
{
    for (const TermSigmas& told : {TermSigmas{}, northTold(3_deg)}) {
        const Proposal proposal = proposalOf(swung(39.5_deg), withNorth(37.5_deg), told);
        EXPECT_NEAR(39.5, proposal.terms.azimuthOffset.degrees(), 1e-9);
        EXPECT_EQ(2.4_deg, *proposal.sigmas[indexOf(Term::AzimuthOffset)]);
        EXPECT_TRUE(proposal.stays.isEmpty());
        EXPECT_TRUE(proposal.warnings.empty());
    }
}

// The difference is larger than both errors. An operator who moved the mount needs the north of the compass. An
// operator who brought iron near must not accept it.
TEST(SwingProposal, ANorthThatTheCompassContradictsIsReplacedWithAWarning)
{
    const Proposal stays = proposalOf(swung(357.6_deg), withNorth(4.7_deg), northTold(0.11_deg));
    EXPECT_FALSE(stays.stays.isEmpty()) << "7.1° the shorter way";
    const Proposal proposal = proposalOf(swung(357.4_deg), withNorth(4.7_deg), northTold(0.11_deg));
    EXPECT_NEAR(-2.6, proposal.terms.azimuthOffset.degrees(), 1e-9) << "nearest to what is in force";
    EXPECT_TRUE(proposal.stays.isEmpty());
    ASSERT_EQ(1U, proposal.warnings.size());
    EXPECT_TRUE(proposal.warnings[0].contains(QStringLiteral("7.3°"))) << proposal.warnings[0].toStdString();
    EXPECT_TRUE(proposal.warnings[0].contains(QStringLiteral("moved")));
    EXPECT_TRUE(proposal.warnings[0].contains(QStringLiteral("iron")));
}

TEST(SwingProposal, ATiltThatPointsHaveToldBetterStays)
{
    profile::Profile profile = withNorth(37.5_deg);
    profile.pointing.tiltNorth = 0.5_deg;
    TermSigmas told = northTold(0.11_deg);
    told[indexOf(Term::TiltNorth)] = 0.02_deg;
    told[indexOf(Term::TiltEast)] = 0.04_deg;
    const Proposal stays = proposalOf(swung(37.4_deg, 0.6_deg), profile, told);
    EXPECT_EQ(0.5_deg, stays.terms.tiltNorth);
    EXPECT_FALSE(stays.sigmas[indexOf(Term::TiltNorth)]) << "else it would count as what the swing has found";
    EXPECT_EQ(QStringLiteral("North stays unchanged. It is known to 0.11°, by compass only to 2.4°. "
                             "The tilt stays unchanged. It is known to 0.04°, by a swing only to 0.05°."),
              stays.stays);
    // The mast leans in another way today.
    const Proposal contradicts = proposalOf(swung(37.4_deg, 0.8_deg), profile, told);
    EXPECT_EQ(0.8_deg, contradicts.terms.tiltNorth);
    ASSERT_EQ(1U, contradicts.warnings.size());
    EXPECT_TRUE(contradicts.warnings[0].contains(QStringLiteral("0.30°"))) << contradicts.warnings[0].toStdString();
    // A roll of the box turns the direction of the tilt. So the size of the tilt is known better than its two parts,
    // and the terms are the parts.
    SwingOutcome rolled = swung(37.4_deg, 0.6_deg);
    rolled.tilt->sizeSigma = 0.01_deg;
    EXPECT_EQ(0.5_deg, proposalOf(rolled, profile, told).terms.tiltNorth);
    told[indexOf(Term::TiltEast)] = {};
    EXPECT_EQ(0.6_deg, proposalOf(swung(37.4_deg, 0.6_deg), profile, told).terms.tiltNorth)
        << "half of it is not known";
}

// A sensor that was averaged at a standstill has no curve: its offset is turned so that it agrees with north.
// REQ-NORTH-36b (SensorProposal.*)
TEST(SensorProposal, ANorthThatPointsHaveToldBetterStays)
{
    calibration::SensorOffset offset;
    offset.offset = {43_deg, 6_deg};
    profile::Profile profile = withNorth(37.5_deg);
    profile.sensor.mounting.azimuthOffset = 2_deg;
    const Proposal proposal = proposalOf(offset, profile, northTold(0.11_deg));
    EXPECT_EQ(profile.pointing, proposal.terms);
    EXPECT_EQ(QStringLiteral("North stays unchanged. It is known to 0.11°, by compass only to 6.0°."), proposal.stays);
    EXPECT_NEAR(-3.5, proposal.sensor->azimuthOffset.degrees(), 1e-9);
    EXPECT_FALSE(proposal.sensor->curve);
    EXPECT_TRUE(proposal.warnings.empty()) << "that north is known badly by it harms nobody";
    const Proposal before = proposalOf(offset, profile);
    EXPECT_NEAR(43.0, before.terms.azimuthOffset.degrees(), 1e-9);
    EXPECT_FALSE(before.sensor);
}

// REQ-NORTH-961: A north that was measured where steel disturbs the compass is proposed as an unreliable result.
TEST(SensorProposal, ANorthFromBesideSteelIsUnreliable)
{
    calibration::SensorOffset offset;
    offset.offset = {43_deg, 2_deg};
    EXPECT_TRUE(proposalOf(offset, {}).doubts.empty());
    offset.isReliableHere = false;
    const Proposal proposal = proposalOf(offset, {});
    EXPECT_TRUE(proposal.warnings.empty());
    ASSERT_EQ(proposal.doubts.size(), 1u);
    EXPECT_EQ(proposal.doubts[0],
              QStringLiteral("Steel disturbs the compass at this heading (result of the swing). Measure at another "
                             "heading."));
}

// REQ-NORTH-39a: Points check the zero of elevation that was set with a level. The proposal says how far the level was
// off, or how accurate it was. A zero that points have determined does not count as set with a level.
TEST(PointsProposal, SunAndMoonCheckTheLevel)
{
    profile::Profile profile;
    profile.pointing.elevationOffset = 1_deg;
    calibration::PointingFit fit{.terms = profile.pointing};
    calibration::FittedTerm& zero = fit.fitted[indexOf(Term::ElevationOffset)];
    zero = {.estimate = {1.4_deg, 0.05_deg}, .state = calibration::TermState::Fitted};
    const auto remark = [&](const TermSigmas& told = {}) { return proposalOf(fit, {}, profile, told).remark; };
    EXPECT_EQ(remark(), QString::fromUtf8("Your level is off by 0.40° ± 0.05°."));
    zero.estimate.value = 0.6_deg;
    EXPECT_EQ(remark(), QString::fromUtf8("Your level is off by 0.40° ± 0.05°."));
    zero.estimate.value = 1.09_deg;
    EXPECT_EQ(remark(), QString::fromUtf8("Your level is right to 0.05°."));
    TermSigmas told;
    told[indexOf(Term::ElevationOffset)] = 0.1_deg;
    EXPECT_EQ(remark(told), QString());
    zero.state = calibration::TermState::Held;
    EXPECT_EQ(remark(), QString()) << "one point tells north only";
}

}  // namespace
}  // namespace boresight
