// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/compass_swing.h"

#include <QString>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

// What becomes of the readings of a swing, and what they say while it still turns. Pure.
namespace boresight::calibration {

// How many readings had which fate.
class SwingTally
{
public:
    // While it turns: nothing is known of outliers yet.
    SwingTally(std::span<const SwingSample> samples, const SwingLimits& limits);
    explicit SwingTally(std::span<const SwingResidual> fitted);

    [[nodiscard]] std::size_t all() const;
    [[nodiscard]] std::size_t of(SampleFate fate) const { return m_counts[static_cast<std::size_t>(fate)]; }
    [[nodiscard]] std::size_t leftOut() const { return all() - of(SampleFate::Used); }
    // "4 far off the curve, 2 turning too fast"; empty: none is left out.
    [[nodiscard]] QString whyLeftOut(const SwingLimits& limits) const;

private:
    std::array<std::size_t, kSampleFates> m_counts{};
};

// A reading as it comes: north is what the readings so far say on the average, and nothing is fitted yet.
struct SwingDot
{
    Angle heading;  // about true
    Angle error;    // of the sensor, about its mean so far
    Turning turning = Turning::Clockwise;
    bool isUsed = true;

    bool operator==(const SwingDot&) const = default;
};

// Thinned evenly where there are more than `most`. `sense`: as long as the readings do not show it.
[[nodiscard]] std::vector<SwingDot> dotsOf(std::span<const SwingSample> samples, const SwingLimits& limits,
                                           AzimuthSense sense, std::size_t most);

}  // namespace boresight::calibration
