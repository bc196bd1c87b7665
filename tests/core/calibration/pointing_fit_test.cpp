// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/pointing_fit.h"

#include "tests/core/calibration/mentions.h"
#include "tests/fakes/sun_points.h"
#include "tests/fakes/text_of.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace boresight::calibration {
namespace {

using fakes::SunDay;
using pointing::PointingModel;
using pointing::PointingTerms;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

PointingTerms hiddenModel()
{
    PointingTerms terms;
    terms.azimuthOffset = 37.4_deg;
    terms.elevationOffset = -0.8_deg;
    terms.tiltNorth = 0.45_deg;
    terms.tiltEast = -0.4_deg;
    terms.collimation = 0.3_deg;
    terms.nonPerpendicularity = 0.08_deg;
    terms.elevationSag = 0.12_deg;
    return terms;
}

CalibrationPoint pointAt(const PointingTerms& terms, Angle azimuth, Angle elevation)
{
    const SkyPointing truth{azimuth, elevation};
    return {.axes = PointingModel(terms).toAxes(truth).axes,
            .truth = truth,
            .sigma = 0.01_deg,
            .when = {},
            .label = QStringLiteral("source")};
}

// Points all round the sky, low and high.
std::vector<CalibrationPoint> allRound(const PointingTerms& terms, int count, double noise = 0.0, unsigned seed = 1)
{
    std::mt19937_64 random(seed);
    std::normal_distribution<double> gaussian(0.0, noise > 0.0 ? noise : 1.0);
    std::vector<CalibrationPoint> points;
    for (int i = 0; i < count; ++i) {
        const Angle elevation = Angle::fromDegrees(12.0 + (i * 23) % 74);
        CalibrationPoint point = pointAt(terms, Angle::fromDegrees(i * 137.5).wrapped360(), elevation);
        if (noise > 0.0) {
            point.axes.azimuth += Angle::fromDegrees(gaussian(random) / std::cos(elevation.radians()));
            point.axes.elevation += Angle::fromDegrees(gaussian(random));
        }
        points.push_back(point);
    }
    return points;
}

double off(const PointingFit& fit, const PointingTerms& truth, Term term)
{
    return (valueOf(fit.terms, term) - valueOf(truth, term)).wrapped180().degrees();
}

std::string fitReason(const std::vector<CalibrationPoint>& points)
{
    const auto fit = fitPointing(points, {});
    return fit ? "accepted" : textOf(fit.error());
}

// REQ-CALIBRATION-12: One point determines the azimuth offset, two points the elevation offset as well. Other terms
// change only from three points on, within what is known of them. They count as fitted from 4 (tilt) or 6 points on.
TEST(PointingFit, OnePointGivesTheOffsetOfAzimuthOnly)
{
    PointingTerms before;
    before.elevationOffset = 0.5_deg;
    before.tiltNorth = 0.3_deg;
    PointingTerms truth = before;
    truth.azimuthOffset = 217.4_deg;  // far from the model in effect
    const auto fit = fitPointing(allRound(truth, 1), before);
    ASSERT_TRUE(fit.has_value());
    EXPECT_NEAR(off(*fit, truth, Term::AzimuthOffset), 0.0, 1e-9);
    EXPECT_EQ(fit->terms.tiltNorth, before.tiltNorth);  // the terms in effect stay
    EXPECT_EQ(fit->terms.elevationOffset, before.elevationOffset);
    EXPECT_EQ(fit->count(TermState::Fitted), 1);
    EXPECT_EQ(fit->count(TermState::Off), 6);
    EXPECT_EQ(fit->of(Term::AzimuthOffset).why.toStdString(), "");
    EXPECT_EQ(fit->of(Term::TiltEast).why.toStdString(), "kept at its known value until there are 4 points");
    EXPECT_FALSE(fit->rmsLeftOut.has_value());
    // One point cannot separate an offset from a collimation of 0.3° and a tilt of 1°.
    EXPECT_GT(fit->of(Term::AzimuthOffset).estimate.sigma, 0.3_deg);
}

// REQ-CALIBRATION-12
TEST(PointingFit, TwoPointsGiveTheOffsetOfElevationToo)
{
    PointingTerms truth;
    truth.azimuthOffset = 37.4_deg;
    truth.elevationOffset = -1.2_deg;
    const auto fit = fitPointing(allRound(truth, 2), {});
    ASSERT_TRUE(fit.has_value());
    EXPECT_NEAR(off(*fit, truth, Term::AzimuthOffset), 0.0, 1e-5);
    EXPECT_NEAR(off(*fit, truth, Term::ElevationOffset), 0.0, 1e-4);
    EXPECT_EQ(fit->count(TermState::Fitted), 2);
}

TEST(PointingFit, ManyPointsGiveEveryTerm)
{
    auto points = allRound(hiddenModel(), 24);
    for (CalibrationPoint& point : points) {
        point.sigma = 0.002_deg;
    }
    const auto fit = fitPointing(points, {});
    ASSERT_TRUE(fit.has_value());
    EXPECT_EQ(fit->count(TermState::Fitted), 7);
    for (const Term term : kAllTerms) {
        EXPECT_NEAR(off(*fit, hiddenModel(), term), 0.0, 0.005) << nameOf(term);
    }
    EXPECT_LT(fit->rmsAfter, 0.001_deg);
    EXPECT_GT(fit->rmsBefore, 20_deg);
    ASSERT_TRUE(fit->rmsLeftOut.has_value());
    EXPECT_LT(*fit->rmsLeftOut, 0.005_deg);
}

// REQ-CALIBRATION-13: A term that the points do not require keeps its value in effect, or its measured value.
TEST(PointingFit, TermsThatThePointsDoNotAskForStayOff)
{
    PointingTerms truth;
    truth.azimuthOffset = 37.4_deg;
    truth.elevationOffset = 0.5_deg;
    int off = 0;
    for (unsigned seed = 1; seed <= 20; ++seed) {
        const auto fit = fitPointing(allRound(truth, 12, 0.01, seed), {});
        ASSERT_TRUE(fit.has_value());
        EXPECT_EQ(fit->of(Term::AzimuthOffset).state, TermState::Fitted);
        EXPECT_EQ(fit->of(Term::ElevationOffset).state, TermState::Fitted);
        if (fit->of(Term::ElevationSag).state == TermState::Off) {
            EXPECT_EQ(fit->of(Term::ElevationSag).why.toStdString(), "the points fit without this term");
        }
        off += fit->count(TermState::Off);
    }
    EXPECT_GE(off, 20 * 5 * 80 / 100);
}

// REQ-CALIBRATION-12
TEST(PointingFit, TermsAreFittedByTheNumberOfPoints)
{
    const auto three = fitPointing(allRound(hiddenModel(), 3), {});
    const auto four = fitPointing(allRound(hiddenModel(), 4), {});
    const auto eight = fitPointing(allRound(hiddenModel(), 8), {});
    ASSERT_TRUE(three && four && eight);
    EXPECT_EQ(three->count(TermState::Fitted), 2);
    EXPECT_EQ(four->count(TermState::Fitted), 4);
    EXPECT_EQ(four->of(Term::TiltNorth).state, TermState::Fitted);
    EXPECT_NE(four->of(Term::Collimation).state, TermState::Fitted);
    EXPECT_THAT(four->of(Term::Collimation).why, mentions("until there are 6 points"));
    EXPECT_GE(eight->count(TermState::Fitted), 5);
    EXPECT_EQ(eight->of(Term::Collimation).state, TermState::Fitted);
}

// REQ-CALIBRATION-14: Every term has an honest sigma, even if the operator centres less accurately than stated. The
// residuals before and after, and of each point that is left out, are angles on the sky.
TEST(PointingFit, TheSigmasAreHonest)
{
    int inside = 0;
    int all = 0;
    for (unsigned seed = 1; seed <= 60; ++seed) {
        const auto fit = fitPointing(allRound(hiddenModel(), 10, 0.01, seed), {});
        ASSERT_TRUE(fit.has_value());
        for (const Term term : kAllTerms) {
            inside += std::abs(off(*fit, hiddenModel(), term)) < 2.0 * fit->of(term).estimate.sigma.degrees() ? 1 : 0;
            ++all;
        }
    }
    EXPECT_GE(inside, all * 93 / 100);
}

// An operator who centres three times less accurately than stated gets correspondingly larger sigmas.
// REQ-CALIBRATION-14
TEST(PointingFit, ReckonsWithTheScatterThatThereIs)
{
    const auto careful = fitPointing(allRound(hiddenModel(), 20, 0.01), {});
    const auto careless = fitPointing(allRound(hiddenModel(), 20, 0.03), {});
    ASSERT_TRUE(careful && careless);
    EXPECT_LT(careful->noiseScale, 1.4);
    EXPECT_NEAR(careless->noiseScale, 3.0, 0.8);
    EXPECT_GT(careless->of(Term::TiltNorth).estimate.sigma, careful->of(Term::TiltNorth).estimate.sigma * 2.0);
    EXPECT_THAT(careless->hints, Contains(mentions("times more than their sigmas")));
}

// REQ-CALIBRATION-14
TEST(PointingFit, ResidualsAreOnTheSky)
{
    PointingTerms truth;
    truth.azimuthOffset = 2_deg;
    std::vector<CalibrationPoint> points = {pointAt(truth, 100_deg, 60_deg), pointAt(truth, 200_deg, 30_deg)};
    points[1].isUsed = false;
    points[1].axes.elevation += 1_deg;
    const auto fit = fitPointing(points, {});
    ASSERT_TRUE(fit.has_value());
    ASSERT_EQ(fit->points.size(), 2U);
    EXPECT_NEAR(fit->points[0].before.across.degrees(), -2.0 * 0.5, 0.001);
    EXPECT_NEAR(fit->points[0].after.size().degrees(), 0.0, 1e-9);
    // The point that the operator left out is shown, and does not count.
    EXPECT_NEAR(fit->points[1].after.elevation.degrees(), 1.0, 1e-6);
    EXPECT_FALSE(fit->points[1].leftOut.has_value());
    EXPECT_EQ(fit->of(Term::ElevationOffset).state, TermState::Off);
}

// To first order this equals a fit without the point.
// REQ-CALIBRATION-14
TEST(PointingFit, LeavesOutEachPointInTurn)
{
    const auto points = allRound(hiddenModel(), 12, 0.01);
    const auto fit = fitPointing(points, {});
    ASSERT_TRUE(fit.has_value());
    TermSet moving{};
    for (const Term term : kAllTerms) {
        moving[indexOf(term)] = fit->of(term).state != TermState::Off;
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        auto others = points;
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
        for (CalibrationPoint& point : others) {
            point.sigma = point.sigma * fit->noiseScale;
        }
        const auto without = solveTerms(others, fit->terms, moving, TermKnowledge::usual());
        ASSERT_TRUE(without && fit->points[i].leftOut);
        const SkyOffset really = offsetOf(points[i], PointingModel(without->terms));
        EXPECT_NEAR(fit->points[i].leftOut->across.degrees(), really.across.degrees(), 0.0005);
        EXPECT_NEAR(fit->points[i].leftOut->elevation.degrees(), really.elevation.degrees(), 0.0005);
        EXPECT_GE(fit->points[i].leftOut->size(), fit->points[i].after.size());
    }
}

// REQ-CALIBRATION-15: A point that disagrees with five or more others is named. Good points are not named. The fit also
// names the kind of point that is missing.
TEST(PointingFit, NamesAPointThatDoesNotAgreeWithTheOthers)
{
    auto points = allRound(hiddenModel(), 12, 0.01);
    points[4].axes.elevation += 2_deg;
    const auto fit = fitPointing(points, {});
    ASSERT_TRUE(fit.has_value());
    EXPECT_THAT(fit->hints, Contains(mentions("Point 5 is ")));
    EXPECT_THAT(fit->hints, Not(Contains(mentions("Point 6 is "))));
}

// A point in a part of the sky that the others hardly determine may lie far off and still be right.
// REQ-CALIBRATION-15
TEST(PointingFit, AccusesNoGoodPoint)
{
    for (const int count : {3, 4, 6, 12}) {
        int accused = 0;
        constexpr unsigned kRuns = 100;
        for (unsigned seed = 1; seed <= kRuns; ++seed) {
            const auto fit = fitPointing(allRound(hiddenModel(), count, 0.01, seed), {});
            ASSERT_TRUE(fit.has_value());
            accused += std::any_of(fit->hints.begin(), fit->hints.end(),
                                   [](const QString& hint) {
                                       return hint.contains(QLatin1String("from the fit of the other points"));
                                   })
                           ? 1
                           : 0;
        }
        EXPECT_LE(accused, 3) << count << " points";
    }
}

// Terms that were typed, or found by an earlier calibration, stay unless the points contradict them.
// REQ-CALIBRATION-13
TEST(PointingFit, TermsInForceStayUnlessThePointsAskForOthers)
{
    PointingTerms before;
    before.elevationSag = 0.15_deg;
    before.collimation = 0.2_deg;
    PointingTerms truth = before;
    truth.azimuthOffset = 37.4_deg;
    const auto agreeing = fitPointing(allRound(truth, 3, 0.01), before);
    ASSERT_TRUE(agreeing.has_value());
    EXPECT_EQ(agreeing->of(Term::ElevationSag).state, TermState::Off);
    EXPECT_EQ(agreeing->terms.elevationSag, before.elevationSag);
    EXPECT_NEAR(off(*agreeing, truth, Term::Collimation), 0.0, 0.03);
    truth.elevationSag = {};
    truth.collimation = {};
    const auto against = fitPointing(allRound(truth, 16, 0.01), before);
    ASSERT_TRUE(against.has_value());
    EXPECT_NEAR(off(*against, truth, Term::Collimation), 0.0, 0.03);
    EXPECT_NEAR(off(*against, truth, Term::ElevationSag), 0.0, 0.05);
}

// REQ-CALIBRATION-15
TEST(PointingFit, SaysWhatKindOfPointIsMissing)
{
    std::vector<CalibrationPoint> low;
    for (int i = 0; i < 5; ++i) {
        low.push_back(pointAt(hiddenModel(), Angle::fromDegrees(100.0 + 10.0 * i), 30_deg));
    }
    const auto fit = fitPointing(low, {});
    ASSERT_TRUE(fit.has_value());
    EXPECT_THAT(fit->hints, Contains(mentions("All points have nearly the same elevation")));
    EXPECT_THAT(fit->hints, Contains(mentions("All points lie within 40° of azimuth")));
    low.push_back(pointAt(hiddenModel(), 320_deg, 150_deg));  // over the top, at the same elevation
    EXPECT_THAT(fitPointing(low, {})->hints, Not(Contains(mentions("All points have nearly the same elevation"))));
}

// REQ-CALIBRATION-16: A point at the zenith determines nothing about azimuth. A point over the top is as good as any
// other.
TEST(PointingFit, TheZenithSaysNothingAboutAzimuth)
{
    EXPECT_THAT(fitReason({pointAt(hiddenModel(), 10_deg, Angle::fromDegrees(89.9))}), HasSubstr("do not determine"));
    auto points = allRound(hiddenModel(), 10);
    const auto without = fitPointing(points, {});
    CalibrationPoint zenith = pointAt(hiddenModel(), 10_deg, 88_deg);
    zenith.axes.azimuth += 3_deg;  // 0.1° on the sky
    zenith.sigma = 0.1_deg;
    points.push_back(zenith);
    const auto with = fitPointing(points, {});
    ASSERT_TRUE(with && without);
    EXPECT_NEAR(off(*with, hiddenModel(), Term::AzimuthOffset), off(*without, hiddenModel(), Term::AzimuthOffset),
                0.005);
}

// REQ-CALIBRATION-16
TEST(PointingFit, APointOverTheTopIsAsGood)
{
    PointingTerms truth;
    truth.azimuthOffset = 37.4_deg;
    CalibrationPoint point;
    point.axes = {.azimuth = 10_deg, .elevation = 150_deg};
    point.truth = pointing::upright(PointingModel(truth).toSky(point.axes));
    const auto fit = fitPointing({&point, 1}, {});
    ASSERT_TRUE(fit.has_value());
    EXPECT_NEAR(off(*fit, truth, Term::AzimuthOffset), 0.0, 1e-9);
}

TEST(PointingFit, IsRefusedWithTheReason)
{
    EXPECT_THAT(fitReason({}), HasSubstr("There are no points."));
    auto points = allRound(hiddenModel(), 3);
    points[1].sigma = Angle{};
    EXPECT_THAT(fitReason(points), HasSubstr("Point 2 is not a number or has no sigma."));
    points = allRound(hiddenModel(), 3);
    points[2].axes.elevation = Angle::fromDegrees(std::nan(""));
    EXPECT_THAT(fitReason(points), HasSubstr("Point 3 is not a number or has no sigma."));
}

// Any site within 60° of latitude, any date, points spread over the day and centred to 0.02°. The tilt is known from
// the swing to 0.05°. Then north is known, and the beam is right along the arc of the Sun. The azimuth offset as a
// single term is less certain: on a day with a low Sun it cannot be separated from the collimation, and its sigma shows
// this. Points from both sides of the zenith separate them on any day.
struct SunStatistics
{
    int north = 0;
    int onArc = 0;
    int tilt = 0;
    int offset = 0;  // of the azimuth offset as a single term
    int honest = 0;
    int overSky = 0;
};

constexpr int kDays = 100;

SunStatistics sunStatistics(int count, double limit, fakes::Sides sides = fakes::Sides::One)
{
    std::mt19937_64 random(2026);
    std::normal_distribution<double> gaussian(0.0, 0.05);
    SunStatistics result;
    for (int run = 0; run < kDays; ++run) {
        const PointingTerms truth = fakes::randomHidden(random);
        const SunDay day = fakes::randomDay(random);
        TermKnowledge known = TermKnowledge::usual();
        known.of(Term::TiltNorth) = {truth.tiltNorth + Angle::fromDegrees(gaussian(random)), 0.05_deg};
        known.of(Term::TiltEast) = {truth.tiltEast + Angle::fromDegrees(gaussian(random)), 0.05_deg};
        const auto fit = fitPointing(fakes::sunPoints(truth, day, count, 0.02, random, sides), {}, known);
        if (!fit) {
            continue;
        }
        const Angle tiltOff =
            SkyOffset{fit->terms.tiltNorth - truth.tiltNorth, fit->terms.tiltEast - truth.tiltEast}.size();
        const Estimate offset = fit->of(Term::AzimuthOffset).estimate;
        const Angle error = (offset.value - truth.azimuthOffset).wrapped180();
        result.north += fakes::northError(truth, fit->terms) < limit ? 1 : 0;
        result.onArc += fakes::worstOnArc(truth, fit->terms, day) < limit ? 1 : 0;
        result.overSky += fakes::rmsOverSky(truth, fit->terms) < 0.15 ? 1 : 0;
        result.tilt += tiltOff < 0.1_deg ? 1 : 0;
        result.offset += std::abs(error.degrees()) < limit ? 1 : 0;
        result.honest += abs(error) < offset.sigma * 2.0 ? 1 : 0;
    }
    return result;
}

// REQ-CALIBRATION-17: Points are centred to 0.02°. North means the largest azimuth error of a level beam, at any
// azimuth. With three points of the Sun north is within 0.15° on 99 of 100 days, and with six within 0.05° on 97 of 100
// days. The beam along the whole path of the Sun has the same error on 98 and 90 of 100 days. Tilt is within 0.1°.
TEST(PointingFit, ThreePointsOfTheSun)
{
    const SunStatistics result = sunStatistics(3, 0.15);
    EXPECT_GE(result.north, 99);
    EXPECT_GE(result.onArc, 98);
    EXPECT_GE(result.overSky, 95);
    EXPECT_GE(result.honest, 90);
}

// REQ-CALIBRATION-17
TEST(PointingFit, SixPointsOfTheSun)
{
    const SunStatistics result = sunStatistics(6, 0.05);
    EXPECT_GE(result.north, 97);
    EXPECT_GE(result.onArc, 90);
    EXPECT_GE(result.overSky, 97);
    EXPECT_GE(result.tilt, 98);
    EXPECT_GE(result.honest, 92);
}

// REQ-CALIBRATION-17a: If one of three, or two of six of these points are taken over the top, the azimuth offset as a
// single term is within 0.15° and 0.05° on 99 of 100 days, however low the Sun stays.
TEST(PointingFit, PointsOfTheSunFromBothSides)
{
    const SunStatistics three = sunStatistics(3, 0.15, fakes::Sides::Both);
    EXPECT_GE(three.offset, 99);
    EXPECT_GE(three.tilt, 97);
    EXPECT_GE(three.honest, 90);
    const SunStatistics six = sunStatistics(6, 0.05, fakes::Sides::Both);
    EXPECT_GE(six.offset, 99);
    EXPECT_GE(six.north, 95);
    EXPECT_GE(six.tilt, 99);
    EXPECT_GE(six.honest, 92);
}

}  // namespace
}  // namespace boresight::calibration
