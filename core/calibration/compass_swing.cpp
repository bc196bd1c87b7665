// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/compass_swing.h"

#include "core/base/text.h"
#include "core/calibration/circular.h"
#include "core/calibration/fit_words.h"
#include "core/calibration/robust_fit.h"
#include "core/calibration/swing_samples.h"
#include "core/calibration/swing_verdict.h"

#include <algorithm>
#include <cmath>

namespace boresight::calibration {
namespace {

constexpr double kCompassSwingNoiseFloor = Angle::fromDegrees(0.2).radians();
constexpr int kFull = 3;               // calibration
constexpr double kHalfTrusted = 0.25;  // weight at twice the noise

class Swing
{
public:
    Swing(std::span<const SwingSample> samples, const SwingLimits& limits) : m_given(samples), m_limits(limits) {}

    Result<CompassSwing> fit()
    {
        if (const Result<> good = choose(); !good) {
            return tl::unexpected(good.error());
        }
        const auto solved = fitRobustly(problem(), kCompassSwingNoiseFloor);
        if (!solved) {
            return failure(
                ErrorCode::Refused,
                Text::tr("Only %1 samples can be used. That is not enough for a swing.").arg(m_usable.size()));
        }
        takeSolution(*solved);
        takeResiduals(*solved);
        takeSigmas(*solved);
        judge(m_swing, m_usable, m_limits);
        return m_swing;
    }

private:
    Result<> choose()
    {
        for (std::size_t i = 0; i < m_given.size(); ++i) {
            if (!m_given[i].axisAzimuth.isFinite()) {
                return failure(ErrorCode::InvalidInput,
                               Text::tr("The position of the mount at sample %1 is unknown.").arg(i + 1));
            }
            m_swing.samples.push_back({.sample = i, .fate = fateOf(m_given[i], m_limits)});
            if (m_swing.samples.back().fate == SampleFate::Used) {
                m_usable.push_back(m_given[i]);
                m_places.push_back(i);
            }
        }
        m_swing.coverage = coverageOf(m_usable);
        m_swing.harmonics = harmonicsFor(m_swing.coverage);
        if (m_swing.harmonics == Harmonics::None) {
            return failure(ErrorCode::Refused, whyTooLittle(m_swing, m_limits));
        }
        const auto sense = senseOf(m_usable);
        if (!sense) {
            return failure(ErrorCode::Refused,
                           Text::tr("The heading of the sensor does not follow the mount in either direction."));
        }
        m_swing.curve.sense = *sense;
        return {};
    }

    // Coefficients of offset, a1, b1, a2, b2 for the azimuth of the axis, then half the hysteresis if the mount turned
    // both ways.
    [[nodiscard]] std::vector<double> row(const SwingSample& sample) const
    {
        const double azimuth = sample.axisAzimuth.radians();
        std::vector<double> row = {1.0, std::sin(azimuth), std::cos(azimuth)};
        if (m_swing.harmonics == Harmonics::FirstAndSecond) {
            row.insert(row.end(), {std::sin(2.0 * azimuth), std::cos(2.0 * azimuth)});
        }
        if (m_swing.coverage.bothWays) {
            row.push_back(sample.turning == Turning::Clockwise ? 1.0 : -1.0);
        }
        return row;
    }

    [[nodiscard]] double weight(const SwingSample& sample) const
    {
        return sample.magnetometerCalibration.value_or(kFull) >= kFull ? 1.0 : kHalfTrusted;
    }

    [[nodiscard]] RobustProblem problem()
    {
        std::vector<Angle> offsets;
        offsets.reserve(m_usable.size());
        for (const SwingSample& sample : m_usable) {
            offsets.push_back(headingOffset(sample, m_swing.curve.sense));
        }
        m_middle = circularMean(offsets).direction;
        RobustProblem problem(row(m_usable.front()).size());
        for (std::size_t i = 0; i < m_usable.size(); ++i) {
            problem.add(row(m_usable[i]), (offsets[i] - m_middle).wrapped180().radians(), weight(m_usable[i]));
        }
        return problem;
    }

    // The fit uses the azimuth of the axis, the curve uses the true heading. So the harmonics are turned.
    void takeSolution(const RobustFit& fit)
    {
        const auto angle = [&](std::size_t unknown) { return Angle::fromRadians(fit.solution[unknown]); };
        const bool second = m_swing.harmonics == Harmonics::FirstAndSecond;
        const Angle north = m_middle + angle(0);
        m_swing.north.value = north.wrapped360();
        const DeviationCurve aboutAxis{.sense = m_swing.curve.sense,
                                       .constant = north,
                                       .a1 = angle(1),
                                       .b1 = angle(2),
                                       .a2 = second ? angle(3) : Angle{},
                                       .b2 = second ? angle(4) : Angle{},
                                       .scatter = Angle::fromRadians(fit.rms),
                                       .elevation = meanElevation()};
        m_swing.curve = aboutAxis.withNorthMoved(north);
        m_swing.curve.constant = Angle{};
        if (m_swing.coverage.bothWays) {
            const std::size_t last = fit.solution.size() - 1;
            m_swing.hysteresis = {angle(last) * 2.0, Angle::fromRadians(2.0 * std::sqrt(fit.variance(last)))};
        }
    }

    void takeResiduals(const RobustFit& fit)
    {
        for (SwingResidual& one : m_swing.samples) {
            const SwingSample& sample = m_given[one.sample];
            one.heading = (sample.axisAzimuth + m_swing.north.value).wrapped360();
            one.error = (headingOffset(sample, m_swing.curve.sense) - m_swing.north.value).wrapped180();
            one.residual = (one.error - m_swing.curve.deviation(one.heading)).wrapped180();
        }
        for (std::size_t i = 0; i < m_places.size(); ++i) {
            SwingResidual& one = m_swing.samples[m_places[i]];
            one.fate = fit.used[i] ? SampleFate::Used : SampleFate::Outlier;
        }
        m_swing.curve.unreliable =
            widened(unreliableSectors(m_swing.samples, m_limits.unreliable), m_swing.samples, m_limits.unreliable);
    }

    // The error that the readings cannot show (METHOD.md, "What a swing cannot see").
    [[nodiscard]] Angle systematic() const
    {
        const Angle softIron = m_swing.curve.secondAmplitude() / std::numbers::sqrt2;
        Angle sigma = hypot(hypot(m_limits.leastConstant, softIron), m_limits.alignment);
        if (m_swing.harmonics == Harmonics::First) {
            sigma = hypot(sigma, m_limits.unseenHarmonic);
        }
        if (!m_swing.coverage.bothWays) {
            sigma = hypot(sigma, meanRate() * m_limits.latencySigma);
        }
        return sigma;
    }

    // Empty unless every sample has an elevation.
    [[nodiscard]] std::optional<Angle> meanElevation() const
    {
        Angle sum;
        for (const SwingSample& sample : m_usable) {
            if (!sample.axisElevation) {
                return std::nullopt;
            }
            sum += *sample.axisElevation;
        }
        return sum / static_cast<double>(m_usable.size());
    }

    [[nodiscard]] AngularRate meanRate() const
    {
        AngularRate sum;
        for (const SwingSample& sample : m_usable) {
            sum += abs(sample.axisRate);
        }
        return sum / static_cast<double>(m_usable.size());
    }

    void takeSigmas(const RobustFit& fit)
    {
        const std::size_t harmonics = m_swing.harmonics == Harmonics::FirstAndSecond ? 4 : 2;
        double largest = 0.0;
        for (std::size_t i = 1; i <= harmonics; ++i) {
            largest = std::max(largest, fit.variance(i));
        }
        m_swing.coefficientSigma = Angle::fromRadians(std::sqrt(largest));
        m_swing.statistical = Angle::fromRadians(std::sqrt(fit.variance(0)));
        m_swing.systematic = systematic();
        m_swing.north.sigma = hypot(m_swing.statistical, m_swing.systematic);
        m_swing.curve.constantSigma = m_swing.north.sigma;
    }

    std::span<const SwingSample> m_given;
    const SwingLimits& m_limits;
    std::vector<SwingSample> m_usable;
    std::vector<std::size_t> m_places;  // indices of the usable samples among the given
    Angle m_middle;
    CompassSwing m_swing;
};

}  // namespace

Result<CompassSwing> fitCompassSwing(std::span<const SwingSample> samples, const SwingLimits& limits)
{
    return Swing(samples, limits).fit();
}

}  // namespace boresight::calibration
