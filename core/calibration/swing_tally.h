// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/compass_swing.h"

#include <QString>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

// Which readings of a swing are used, and what they show while the mount still turns. Pure.
namespace boresight::calibration {

// Counts how many readings of a swing were used or left out, and why.
class SwingTally
{
public:
    // While the mount turns: outliers are not known yet.
    SwingTally(std::span<const SwingSample> samples, const SwingLimits& limits);
    explicit SwingTally(std::span<const SwingResidual> fitted);

    [[nodiscard]] std::size_t all() const;
    [[nodiscard]] std::size_t of(SampleFate fate) const { return m_counts[static_cast<std::size_t>(fate)]; }
    [[nodiscard]] std::size_t leftOut() const { return all() - of(SampleFate::Used); }
    // For example "4 far off the curve, 2 turning too fast". Empty: no reading is left out.
    [[nodiscard]] QString whyLeftOut(const SwingLimits& limits) const;

private:
    std::array<std::size_t, kSampleFates> m_counts{};
};

// A reading before any fit: north is the mean of the readings so far.
struct SwingDot
{
    Angle heading;  // approximately true
    Angle error;    // of the sensor, relative to its mean so far
    Turning turning = Turning::Clockwise;
    bool isUsed = true;

    bool operator==(const SwingDot&) const = default;
};

// Thinned evenly to at most `most` dots. `sense`: used while the readings do not show it.
[[nodiscard]] std::vector<SwingDot> dotsOf(std::span<const SwingSample> samples, const SwingLimits& limits,
                                           AzimuthSense sense, std::size_t most);

}  // namespace boresight::calibration
