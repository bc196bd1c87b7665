// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/swing_verdict.h"

#include "core/base/text.h"
#include "core/calibration/fit_words.h"
#include "core/calibration/swing_samples.h"
#include "core/calibration/swing_tally.h"

#include <algorithm>
#include <cmath>

namespace boresight::calibration {
namespace {

constexpr double kFollowsCurrent = 0.6;                   // coefficient of correlation
constexpr Angle kWorthTelling = Angle::fromDegrees(2.0);  // smallest reported hysteresis, and effect of the current
constexpr Angle kFarAway = Angle::fromDegrees(45.0);      // of elevation

// Part of the readings that may be left out without a remark.
constexpr double kFewLeftOut = 0.1;

// Without the room beyond the edges, in which most readings are good.
Angle unreliableArc(const CompassSwing& swing, Angle limit)
{
    Angle sum;
    for (const UnreliableSector& sector : unreliableSectors(swing.samples, limit)) {
        sum += sector.width();
    }
    return sum;
}

struct CurrentEffect
{
    double correlation = 0.0;
    Angle amplitude;  // rms of the part of the residuals that follows the current
};

// The correlation between the residuals of the curve and the current of the motors.
CurrentEffect effectOfCurrent(const CompassSwing& swing, std::span<const SwingSample> usable)
{
    double n = 0.0, current = 0.0, residual = 0.0, currentSquare = 0.0, residualSquare = 0.0, product = 0.0;
    std::size_t next = 0;
    for (const SwingResidual& sample : swing.samples) {
        if (sample.fate != SampleFate::Used && sample.fate != SampleFate::Outlier) {
            continue;
        }
        const double amperes = usable[next++].motorCurrent;
        const double off = sample.residual.radians();
        n += 1.0;
        current += amperes;
        residual += off;
        currentSquare += amperes * amperes;
        residualSquare += off * off;
        product += amperes * off;
    }
    const double currents = currentSquare / n - current / n * (current / n);
    const double residuals = residualSquare / n - residual / n * (residual / n);
    if (!(currents > 1e-12) || !(residuals > 1e-12)) {
        return {};
    }
    const double correlation = (product / n - current / n * (residual / n)) / std::sqrt(currents * residuals);
    return {.correlation = correlation, .amplitude = Angle::fromRadians(std::abs(correlation) * std::sqrt(residuals))};
}

class SwingJudge
{
public:
    SwingJudge(CompassSwing& swing, const SwingLimits& limits)
        : m_swing(swing), m_limits(limits), m_tally(swing.samples)
    {}

    void hopeless()
    {
        const DeviationCurve& curve = m_swing.curve;
        if (curve.scatter > m_limits.hopelessRms) {
            giveUp(Text::tr("The readings scatter by %1 about the curve.").arg(inWords(curve.scatter)));
        }
        if (curve.firstAmplitude() > m_limits.hopelessAmplitude) {
            giveUp(Text::tr("Iron near the sensor deflects the compass by %1. It is nearly as strong as the field of "
                            "the Earth.")
                       .arg(inWords(curve.firstAmplitude())));
        }
        if (!curve.isInvertible()) {
            giveUp(Text::tr("The compass error is so steep that different directions give nearly the same reading."));
        }
        const auto outliers = static_cast<double>(m_tally.of(SampleFate::Outlier));
        const auto tried = outliers + static_cast<double>(m_tally.of(SampleFate::Used));
        if (outliers > m_limits.hopelessPart * tried) {
            giveUp(Text::tr("%1 of %2 readings are far off the curve.").arg(outliers).arg(tried));
        }
        const Angle arc = unreliableArc(m_swing, m_limits.unreliable);
        if (arc.turns() > m_limits.hopelessPart) {
            giveUp(Text::tr("%1 of the circle is unreliable.").arg(inWords(arc, 0)));
        }
    }

    void hints()
    {
        if (static_cast<double>(m_tally.leftOut()) > kFewLeftOut * static_cast<double>(m_tally.all())) {
            hint(Text::tr("%1 of %2 readings were left out: %3.")
                     .arg(m_tally.leftOut())
                     .arg(m_tally.all())
                     .arg(m_tally.whyLeftOut(m_limits)));
        }
        const SwingCoverage& seen = m_swing.coverage;
        if (m_swing.harmonics == Harmonics::First) {
            hint(Text::tr("Only %1 of 12 sectors have readings, with a gap of %2. Soft iron could not be determined.")
                     .arg(seen.sectors)
                     .arg(inWords(seen.largestGap, 0)));
        }
        if (!seen.isEven) {
            hint(Text::tr("Some sectors have few readings."));
        }
        if (!seen.bothWays) {
            hint(Text::tr("The mount turned in one direction only. Latency and hysteresis are unknown."));
        }
        if (m_swing.hysteresis && abs(m_swing.hysteresis->value) > kWorthTelling) {
            hint(Text::tr("The two directions of turning differ by %1. Either sensor.latency_s is wrong or the mount "
                          "has play. North is the mean of both.")
                     .arg(inWords(m_swing.hysteresis->value)));
        }
        const DeviationCurve& curve = m_swing.curve;
        if (curve.elevation && curve.sigmaAt(*curve.elevation + kFarAway) > kWorthTelling) {
            hint(Text::tr("The curve is valid with the boom at %1. At %2 higher or lower it is uncertain by %3.")
                     .arg(inWords(*curve.elevation, 0), inWords(kFarAway, 0),
                          inWords(curve.sigmaAt(*curve.elevation + kFarAway))));
        }
        for (const UnreliableSector& sector : m_swing.curve.unreliable) {
            hint(Text::tr("From %1 to %2 the compass is off by %3. It is unreliable there.")
                     .arg(trueHeading(sector.from), trueHeading(sector.to), inWords(sector.residual, 0)));
        }
    }

    void current(const CurrentEffect& effect)
    {
        if (std::abs(effect.correlation) > kFollowsCurrent && effect.amplitude > kWorthTelling) {
            hint(Text::tr("The motor current turns the compass by %1.").arg(inWords(effect.amplitude)));
        }
    }

private:
    void giveUp(const QString& reason) { m_swing.hopeless.push_back(reason); }
    void hint(const QString& text) { m_swing.hints.push_back(text); }
    [[nodiscard]] QString trueHeading(Angle heading) const
    {
        return inWords((heading + m_limits.declination).wrapped360(), 0);
    }

    CompassSwing& m_swing;
    const SwingLimits& m_limits;
    const SwingTally m_tally;
};

}  // namespace

void judge(CompassSwing& swing, std::span<const SwingSample> usable, const SwingLimits& limits)
{
    SwingJudge verdict(swing, limits);
    verdict.hopeless();
    verdict.hints();
    verdict.current(effectOfCurrent(swing, usable));
}

QString whyTooLittle(const CompassSwing& swing, const SwingLimits& limits)
{
    const SwingTally tally(swing.samples);
    const auto most = [&](SampleFate fate) { return tally.of(fate) * 2 > tally.all(); };
    if (most(SampleFate::Uncalibrated)) {
        return Text::tr(
                   "In %1 of %2 readings the magnetometer calibration is below %3. Move the sensor in figures of "
                   "eight, away from iron. Then swing again.")
            .arg(tally.of(SampleFate::Uncalibrated))
            .arg(tally.all())
            .arg(limits.calibration);
    }
    if (most(SampleFate::MotorCurrent)) {
        return Text::tr(
                   "In %1 of %2 readings the motor current is above %3 A (sensor.swing_current_a). Look for what "
                   "blocks the mount, or raise this limit.")
            .arg(tally.of(SampleFate::MotorCurrent))
            .arg(tally.all())
            .arg(limits.motorCurrent, 0, 'f', 1);
    }
    return Text::tr(
               "%1 of 12 sectors have readings, with a gap of %2. A swing needs more of the circle. Find north with "
               "the mount standing still instead.")
        .arg(swing.coverage.sectors)
        .arg(inWords(swing.coverage.largestGap, 0));
}

}  // namespace boresight::calibration
