// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/budget/make_budget.h"

#include "core/base/text.h"
#include "core/pointing/beam.h"
#include "core/units/degrees_text.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace boresight::budget {

namespace {

constexpr double kSecondsOfDay = 86'400.0;
constexpr int kFineDecimals = 3;

Angle rootOfSquares(Angle one, Angle other)
{
    return Angle::fromRadians(std::hypot(one.radians(), other.radians()));
}

QString rateWords(AngularRate rate)
{
    return Text::tr("The target moves %1/s.").arg(degreesText(Angle::fromRadians(rate.radians()), 2));
}

// A rotator that reports whole steps cannot show an error inside a step.
ErrorLine servoLine(const BudgetFacts& facts)
{
    if (!facts.servo) {
        return {.part = ErrorPart::Servo, .basis = Text::tr("The axes have not answered a set-point.")};
    }
    QString basis =
        Text::tr("Measured: rms of the last 10 s. Now %1. Peak %2.")
            .arg(degreesText(facts.servo->now, kFineDecimals), degreesText(facts.servo->peak, kFineDecimals));
    if (facts.resolution > Angle{}) {
        basis += QLatin1Char(' ') +
                 Text::tr("The steps of the rotator add %1.").arg(degreesText(facts.resolution, kFineDecimals));
    }
    return {.part = ErrorPart::Servo, .error = rootOfSquares(facts.servo->rms, facts.resolution), .basis = basis};
}

ErrorLine wayLine(const BudgetFacts& facts)
{
    return {
        .part = ErrorPart::Way, .error = facts.toTarget, .basis = Text::tr("From the set-points to the target, now.")};
}

// Without a judged path the target is at most in the middle between two points.
ErrorLine streamLine(const BudgetFacts& facts)
{
    if (facts.origin == TargetOrigin::Own) {
        return {.part = ErrorPart::Stream,
                .error = Angle{},
                .basis = Text::tr("Boresight computes each position. Nothing lies between points.")};
    }
    if (!facts.stream) {
        return {.part = ErrorPart::Stream, .basis = Text::tr("Too few points have arrived.")};
    }
    const QString step = Text::tr("The points are %1 apart.").arg(degreesText(facts.stream->step, 2));
    return facts.stream->foretold
               ? ErrorLine{.part = ErrorPart::Stream,
                           .error = facts.stream->foretold,
                           .basis = step + QLatin1Char(' ') + Text::tr("The path foretold them with this rms error.")}
               : ErrorLine{.part = ErrorPart::Stream,
                           .error = 0.5 * facts.stream->step,
                           .basis = step + QLatin1Char(' ') + Text::tr("Half a step.")};
}

ErrorLine clockLine(const BudgetFacts& facts)
{
    const auto unknown = [](const QString& why) { return ErrorLine{.part = ErrorPart::Clock, .basis = why}; };
    if (facts.origin != TargetOrigin::Own) {
        return unknown(Text::tr("Boresight does not know the clock of the program that sends the points."));
    }
    const QString moves = rateWords(*facts.skyRate);
    if (facts.clock.ahead) {
        return unknown(
            Text::tr("The clock of this computer was set, and Boresight points by the old time. %1").arg(moves));
    }
    if (!facts.clock.isSynchronised) {
        return unknown(Text::tr("No time source sets the clock. %1").arg(moves));
    }
    if (!facts.clock.error) {
        return unknown(Text::tr("The time source reports no error. %1").arg(moves));
    }
    return {.part = ErrorPart::Clock,
            .error = abs(*facts.skyRate) * *facts.clock.error,
            .basis = Text::tr("The time source reports an error of %1 ms. %2")
                         .arg(facts.clock.error->count() * 1e3, 0, 'f', 1)
                         .arg(moves)};
}

ErrorLine elementsLine(const BudgetFacts& facts)
{
    if (facts.origin != TargetOrigin::Own) {
        return {.part = ErrorPart::Elements, .basis = Text::tr("Boresight does not know the elements of the client.")};
    }
    if (!facts.elements) {
        return {.part = ErrorPart::Elements, .basis = Text::tr("The elements of the satellite are not loaded now.")};
    }
    return {.part = ErrorPart::Elements,
            .error = abs(*facts.skyRate) * facts.elements->time,
            .basis = Text::tr("%1 days old. Expected: %2 km along the orbit, %3 s.")
                         .arg(std::abs(facts.elements->age.count()) / kSecondsOfDay, 0, 'f', 1)
                         .arg(facts.elements->kilometres, 0, 'f', 1)
                         .arg(facts.elements->time.count(), 0, 'f', 2)};
}

// After a fit of few points the residuals are smaller than the error. The centring of the points is a lower limit.
ErrorLine calibrationLine(const CalibrationFacts& facts)
{
    if (facts.points.empty()) {
        return facts.stated
                   ? ErrorLine{.part = ErrorPart::Calibration,
                               .error = facts.stated,
                               .basis = Text::tr("The stated uncertainty of the calibration in force.")}
                   : ErrorLine{.part = ErrorPart::Calibration,
                               .basis = Text::tr("No point was measured, and north has no stated uncertainty.")};
    }
    double residuals = 0.0;
    double sigmas = 0.0;
    for (const PointFacts& point : facts.points) {
        residuals += point.residual.radians() * point.residual.radians();
        sigmas += point.sigma.radians() * point.sigma.radians();
    }
    const double mean = std::max(residuals, sigmas) / static_cast<double>(facts.points.size());
    return {.part = ErrorPart::Calibration,
            .error = Angle::fromRadians(std::sqrt(mean)),
            .basis = Text::tr("Residual rms of the measured points (%1), at least the uncertainty of their centring.")
                         .arg(facts.points.size())};
}

// What the wind does to the axes is measured as a part of the servo. What it bends is not measured by anything.
ErrorLine windLine(const WindFacts& facts)
{
    const QString bends = Text::tr("Not in the sum. Nothing measures how far the wind bends mast and antenna.");
    const QString speed = !facts.isRead ? QString()
                          : facts.speed ? Text::tr("Wind %1 m/s.").arg(*facts.speed, 0, 'f', 1)
                                        : Text::tr("No fresh wind reading.");
    return {.part = ErrorPart::Wind, .basis = speed.isEmpty() ? bends : speed + QLatin1Char(' ') + bends};
}

void addUp(ErrorBudget& budget, Angle beamWidth)
{
    for (const ErrorLine& line : budget.lines) {
        budget.sum = rootOfSquares(budget.sum, line.error.value_or(Angle{}));
        budget.isWhole = budget.isWhole && (line.error || line.part == ErrorPart::Wind);
    }
    budget.loss = pointing::pointingLoss(budget.sum, beamWidth);
}

}  // namespace

ErrorBudget makeBudget(const BudgetFacts& facts)
{
    const bool isOwn = facts.origin == TargetOrigin::Own && facts.skyRate;
    const bool comesInPoints = facts.origin == TargetOrigin::Client || facts.origin == TargetOrigin::Reported;
    ErrorBudget budget{.lines = {servoLine(facts), wayLine(facts)}};
    if (isOwn || comesInPoints) {
        budget.lines.push_back(streamLine(facts));
        budget.lines.push_back(clockLine(facts));
    }
    if ((isOwn && facts.isSatellite) || facts.origin == TargetOrigin::Client) {
        budget.lines.push_back(elementsLine(facts));
    }
    budget.lines.push_back(calibrationLine(facts.calibration));
    budget.lines.push_back(windLine(facts.wind));
    addUp(budget, facts.beamWidth);
    return budget;
}

}  // namespace boresight::budget
