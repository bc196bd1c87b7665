// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/compass_swing.h"

#include <optional>
#include <span>
#include <vector>

// Prepares the fit of a swing: which samples are usable, how much of the circle they cover, which way the sensor
// counts. Steps of fitCompassSwing(); pure.
namespace boresight::calibration {

[[nodiscard]] SampleFate fateOf(const SwingSample& sample, const SwingLimits& limits);

[[nodiscard]] SwingCoverage coverageOf(std::span<const SwingSample> usable);

// As many harmonics as the coverage of the circle allows.
[[nodiscard]] Harmonics harmonicsFor(const SwingCoverage& coverage);

// The sense in which the difference of heading and azimuth stays constant. Empty if both are equally likely.
[[nodiscard]] std::optional<AzimuthSense> senseOf(std::span<const SwingSample> usable);

// The reading, converted to a clockwise sensor, minus the azimuth of the axis.
[[nodiscard]] Angle headingOffset(const SwingSample& sample, AzimuthSense sense);

// Arcs in which the median residual exceeds the limit, in steps of 10°. Outliers count, too.
[[nodiscard]] std::vector<UnreliableSector> unreliableSectors(std::span<const SwingResidual> samples, Angle limit);

// These arcs, up to the next readings that are within the limit. Arcs that meet become one.
[[nodiscard]] std::vector<UnreliableSector> widened(std::span<const UnreliableSector> sectors,
                                                    std::span<const SwingResidual> samples, Angle limit);

}  // namespace boresight::calibration
