// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/swing_tally.h"

#include "core/base/text.h"
#include "core/calibration/circular.h"
#include "core/calibration/swing_samples.h"

#include <QStringList>

#include <algorithm>
#include <numeric>

namespace boresight::calibration {

SwingTally::SwingTally(std::span<const SwingSample> samples, const SwingLimits& limits)
{
    for (const SwingSample& sample : samples) {
        ++m_counts[static_cast<std::size_t>(fateOf(sample, limits))];
    }
}

SwingTally::SwingTally(std::span<const SwingResidual> fitted)
{
    for (const SwingResidual& one : fitted) {
        ++m_counts[static_cast<std::size_t>(one.fate)];
    }
}

std::size_t SwingTally::all() const
{
    return std::accumulate(m_counts.begin(), m_counts.end(), std::size_t{0});
}

QString SwingTally::whyLeftOut(const SwingLimits& limits) const
{
    QStringList reasons;
    const auto add = [&](SampleFate fate, const QString& reason) {
        if (of(fate) > 0) {
            reasons << QStringLiteral("%1 %2").arg(of(fate)).arg(reason);
        }
    };
    add(SampleFate::Outlier, Text::tr("far off the curve"));
    add(SampleFate::Uncalibrated, Text::tr("with magnetometer calibration below %1").arg(limits.calibration));
    add(SampleFate::MotorCurrent,
        Text::tr("at a motor current above %1 A (sensor.swing_current_a)").arg(limits.motorCurrent, 0, 'f', 1));
    add(SampleFate::TooFast, Text::tr("turning faster than %1°/s").arg(limits.rate.degrees(), 0, 'f', 1));
    return reasons.join(QStringLiteral(", "));
}

std::vector<SwingDot> dotsOf(std::span<const SwingSample> samples, const SwingLimits& limits, AzimuthSense sense,
                             std::size_t most)
{
    std::vector<SwingSample> usable;
    std::ranges::copy_if(samples, std::back_inserter(usable),
                         [&](const SwingSample& sample) { return fateOf(sample, limits) == SampleFate::Used; });
    const AzimuthSense shown = usable.empty() ? sense : senseOf(usable).value_or(sense);
    std::vector<Angle> offsets;
    offsets.reserve(usable.size());
    for (const SwingSample& sample : usable) {
        offsets.push_back(headingOffset(sample, shown));
    }
    const Angle north = offsets.empty() ? Angle{} : circularMean(offsets).direction;
    std::vector<SwingDot> dots;
    const std::size_t count = std::min(samples.size(), most);
    for (std::size_t i = 0; i < count; ++i) {
        const SwingSample& sample = samples[i * samples.size() / count];
        dots.push_back({.heading = (sample.axisAzimuth + north).wrapped360(),
                        .error = (headingOffset(sample, shown) - north).wrapped180(),
                        .turning = sample.turning,
                        .isUsed = fateOf(sample, limits) == SampleFate::Used});
    }
    return dots;
}

}  // namespace boresight::calibration
