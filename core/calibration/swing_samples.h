// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/compass_swing.h"

#include <optional>
#include <span>
#include <vector>

// What a swing can be fitted with: which samples are fit for use, how much of the circle they saw, which way the sensor
// counts. Steps of fitCompassSwing(); pure.
namespace boresight::calibration {

[[nodiscard]] SampleFate fateOf(const SwingSample& sample, const SwingLimits& limits);

[[nodiscard]] SwingCoverage coverageOf(std::span<const SwingSample> usable);

// As many as the circle was seen well enough for: a second harmonic needs what a first one does not.
[[nodiscard]] Harmonics harmonicsFor(const SwingCoverage& coverage);

// The sense in which heading less azimuth stays the same; nothing if both are as likely.
[[nodiscard]] std::optional<AzimuthSense> senseOf(std::span<const SwingSample> usable);

// Reading of a sensor that counts clockwise, less the azimuth of the axis.
[[nodiscard]] Angle headingOffset(const SwingSample& sample, AzimuthSense sense);

// Arcs in which the middle residual is beyond the limit, in steps of 10°; outliers count, too.
[[nodiscard]] std::vector<UnreliableSector> unreliableSectors(std::span<const SwingResidual> samples, Angle limit);

}  // namespace boresight::calibration
