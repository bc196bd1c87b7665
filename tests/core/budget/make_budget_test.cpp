// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/budget/make_budget.h"

#include "core/orbit/element_age.h"
#include "core/pointing/beam.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace boresight::budget {
namespace {

// A satellite in the zenith of a mount, by Boresight's own orbit: 7.66 km/s at 420 km are 1.045 °/s.
BudgetFacts ownSatellite()
{
    return {.beamWidth = 10_deg,
            .servo = ServoRecord::Summary{.now = 0.02_deg, .rms = 0.03_deg, .peak = 0.05_deg},
            .toTarget = 0.04_deg,
            .origin = TargetOrigin::Own,
            .skyRate = 1.045_deg_s,
            .clock = {.isSynchronised = true, .error = Seconds(0.010)},
            .isSatellite = true,
            .elements = ElementFacts{.age = Seconds(2.0 * 86'400.0), .kilometres = 4.0, .time = Seconds(0.5222)},
            .calibration = {
                .points = {{.residual = 0.1_deg, .sigma = 0.05_deg}, {.residual = 0.1_deg, .sigma = 0.05_deg}}}};
}

const ErrorLine* lineOf(const ErrorBudget& budget, ErrorPart part)
{
    const auto found = std::ranges::find(budget.lines, part, &ErrorLine::part);
    return found == budget.lines.end() ? nullptr : &*found;
}

// In degrees. A part that is missing or unknown is -1.
double degreesOf(const ErrorBudget& budget, ErrorPart part)
{
    const ErrorLine* const line = lineOf(budget, part);
    return line != nullptr && line->error ? line->error->degrees() : -1.0;
}

bool isUnknown(const ErrorBudget& budget, ErrorPart part)
{
    const ErrorLine* const line = lineOf(budget, part);
    return line != nullptr && !line->error && !line->basis.isEmpty();
}

// REQ-BUDGET-03: The parts of the error are independent, so their squares are added. The loss is that of the sum, by
// the formula of core/pointing.
TEST(MakeBudget, AddsThePartsAsSquares)
{
    const ErrorBudget budget = makeBudget(ownSatellite());
    EXPECT_NEAR(degreesOf(budget, ErrorPart::Servo), 0.03, 1e-12);
    EXPECT_NEAR(degreesOf(budget, ErrorPart::Way), 0.04, 1e-12);
    EXPECT_NEAR(degreesOf(budget, ErrorPart::Stream), 0.0, 1e-12);
    EXPECT_NEAR(degreesOf(budget, ErrorPart::Clock), 0.01045, 1e-9);
    EXPECT_NEAR(degreesOf(budget, ErrorPart::Elements), 0.5457, 1e-4);  // atan(4 km / 420 km)
    EXPECT_NEAR(degreesOf(budget, ErrorPart::Calibration), 0.1, 1e-12);
    // By hand: sqrt(0.0009 + 0.0016 + 0.000109 + 0.29779 + 0.01) = 0.5571
    EXPECT_NEAR(budget.sum.degrees(), 0.5571, 1e-4);
    EXPECT_TRUE(budget.isWhole);
    ASSERT_TRUE(budget.loss);
    EXPECT_NEAR(*budget.loss, 12.0 * 0.05571 * 0.05571, 1e-4);
    EXPECT_EQ(budget.loss, pointing::pointingLoss(budget.sum, 10_deg));
}

// REQ-BUDGET-04: An unknown part is named with the reason. It adds nothing, and the sum is not whole.
TEST(MakeBudget, AnUnknownClockIsNotGuessed)
{
    BudgetFacts facts = ownSatellite();
    facts.clock.error.reset();
    EXPECT_TRUE(isUnknown(makeBudget(facts), ErrorPart::Clock));
    facts.clock = {.isSynchronised = false, .error = Seconds(0.010)};
    EXPECT_TRUE(isUnknown(makeBudget(facts), ErrorPart::Clock));
    EXPECT_THAT(lineOf(makeBudget(facts), ErrorPart::Clock)->basis.toStdString(),
                testing::HasSubstr("No time source sets the clock. The target moves 1.04"));
    facts.clock = {.error = Seconds(0.010), .ahead = Seconds(3.0)};
    const ErrorBudget budget = makeBudget(facts);
    EXPECT_TRUE(isUnknown(budget, ErrorPart::Clock));
    EXPECT_FALSE(budget.isWhole);
    EXPECT_NEAR(budget.sum.degrees(), 0.5570, 1e-4);
}

// REQ-BUDGET-04
TEST(MakeBudget, UnknownElementsServoAndCalibrationAreNamed)
{
    BudgetFacts facts = ownSatellite();
    facts.servo.reset();
    facts.elements.reset();
    facts.calibration = {};
    const ErrorBudget budget = makeBudget(facts);
    for (const ErrorPart part : {ErrorPart::Servo, ErrorPart::Elements, ErrorPart::Calibration}) {
        EXPECT_TRUE(isUnknown(budget, part)) << int(part);
    }
    EXPECT_FALSE(budget.isWhole);
    EXPECT_NEAR(budget.sum.degrees(), std::hypot(0.04, 0.01045), 1e-6);
}

// REQ-BUDGET-05: What the wind bends is not measured by anything. The budget says so, and the sum is whole without it.
TEST(MakeBudget, TheWindIsNotInTheSum)
{
    BudgetFacts facts = ownSatellite();
    const ErrorBudget calm = makeBudget(facts);
    facts.wind = {.isRead = true, .speed = 12.0};
    const ErrorBudget windy = makeBudget(facts);
    EXPECT_EQ(calm.sum, windy.sum);
    EXPECT_TRUE(windy.isWhole);
    EXPECT_TRUE(isUnknown(windy, ErrorPart::Wind));
    EXPECT_THAT(lineOf(windy, ErrorPart::Wind)->basis.toStdString(),
                testing::StartsWith("Wind 12.0 m/s. Not in the sum."));
    facts.wind.speed.reset();
    EXPECT_THAT(lineOf(makeBudget(facts), ErrorPart::Wind)->basis.toStdString(),
                testing::StartsWith("No fresh wind reading. Not in the sum."));
}

// REQ-BUDGET-06: With points of a client the error between them is that of the path at the next point, or half a step
// while no path is judged. The clock and the elements of the client are unknown.
TEST(MakeBudget, TheStreamOfAClient)
{
    BudgetFacts facts = ownSatellite();
    facts.origin = TargetOrigin::Client;
    facts.skyRate.reset();
    facts.isSatellite = false;
    facts.elements.reset();
    facts.stream = tracking::StreamError{.step = 5_deg, .foretold = {}};
    EXPECT_NEAR(degreesOf(makeBudget(facts), ErrorPart::Stream), 2.5, 1e-12);
    facts.stream->foretold = 0.06_deg;
    const ErrorBudget budget = makeBudget(facts);
    EXPECT_NEAR(degreesOf(budget, ErrorPart::Stream), 0.06, 1e-12);
    EXPECT_TRUE(isUnknown(budget, ErrorPart::Clock));
    EXPECT_TRUE(isUnknown(budget, ErrorPart::Elements));
    EXPECT_FALSE(budget.isWhole);
    facts.origin = TargetOrigin::Reported;
    facts.stream.reset();
    EXPECT_TRUE(isUnknown(makeBudget(facts), ErrorPart::Stream));
    EXPECT_EQ(lineOf(makeBudget(facts), ErrorPart::Elements), nullptr) << "a balloon has no elements";
}

// REQ-BUDGET-07: A fixed direction has no part of stream, clock and elements. A star or the Moon has none of elements.
TEST(MakeBudget, OnlyWhatAppliesIsListed)
{
    BudgetFacts facts = ownSatellite();
    facts.isSatellite = false;
    EXPECT_EQ(lineOf(makeBudget(facts), ErrorPart::Elements), nullptr);
    EXPECT_NE(lineOf(makeBudget(facts), ErrorPart::Clock), nullptr);
    facts.origin = TargetOrigin::Fixed;
    const ErrorBudget budget = makeBudget(facts);
    EXPECT_EQ(budget.lines.size(), 4U);
    EXPECT_TRUE(budget.isWhole);
    EXPECT_NEAR(budget.sum.degrees(), std::sqrt(0.0009 + 0.0016 + 0.01), 1e-9);
}

// REQ-BUDGET-08: The calibration counts with the residuals of the measured points, but with no less than the
// uncertainty of their centring. Without points it counts with its stated uncertainty.
TEST(MakeBudget, TheCalibrationIsNoBetterThanItsPoints)
{
    BudgetFacts facts = ownSatellite();
    facts.calibration.points = {{.residual = 0.03_deg, .sigma = 0.2_deg}, {.residual = 0.04_deg, .sigma = 0.2_deg}};
    EXPECT_NEAR(degreesOf(makeBudget(facts), ErrorPart::Calibration), 0.2, 1e-12);
    facts.calibration.points = {{.residual = 0.3_deg, .sigma = 0.2_deg}, {.residual = 0.4_deg, .sigma = 0.2_deg}};
    EXPECT_NEAR(degreesOf(makeBudget(facts), ErrorPart::Calibration), std::sqrt(0.125), 1e-12);
    facts.calibration = {.stated = 1.5_deg};
    EXPECT_NEAR(degreesOf(makeBudget(facts), ErrorPart::Calibration), 1.5, 1e-12);
}

// REQ-BUDGET-09: A rotator that reports whole steps cannot show an error inside a step. A step of 1° adds 0.29° rms.
TEST(MakeBudget, TheStepsOfTheRotatorAreAPartOfTheServo)
{
    BudgetFacts facts = ownSatellite();
    facts.servo = ServoRecord::Summary{};
    facts.resolution = Angle::fromDegrees(1.0 / std::sqrt(12.0));
    EXPECT_NEAR(degreesOf(makeBudget(facts), ErrorPart::Servo), 0.2887, 1e-4);
}

// REQ-BUDGET-10: Beyond one beam width the loss is not stated.
TEST(MakeBudget, TheLossEndsWithTheMainLobe)
{
    BudgetFacts facts = ownSatellite();
    facts.toTarget = 9.9_deg;
    EXPECT_NEAR(makeBudget(facts).loss.value(), 11.8, 0.05);
    facts.toTarget = 30_deg;
    EXPECT_FALSE(makeBudget(facts).loss.has_value());
}

// The numbers of a set of the ISS that is two days old, by the rule of core/orbit: 1 km, and 1.5 km for each day.
TEST(MakeBudget, TwoDaysOldElementsOfTheIss)
{
    orbit::ElementSet iss;
    iss.epoch = orbit::julianDate(UtcTime(std::chrono::days(20000)));
    iss.revolutionsPerDay = 15.5;
    const orbit::AgeError error = orbit::expectedError(iss, UtcTime(std::chrono::days(20002)));
    EXPECT_NEAR(error.kilometres, 4.0, 1e-9);
    BudgetFacts facts = ownSatellite();
    facts.elements = ElementFacts{.age = Seconds(2.0 * 86'400.0), .kilometres = error.kilometres, .time = error.time};
    EXPECT_NEAR(degreesOf(makeBudget(facts), ErrorPart::Elements), 0.546, 0.001);
}

}  // namespace
}  // namespace boresight::budget
