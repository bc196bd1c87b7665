// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/calibration_record.h"

// Whether two models, or two mountings of the sensor, differ by more than rounding. Pure.
namespace boresight {

// Half of the last digit that a profile and a history store, and the rounding of both.
inline constexpr Angle kSameTerm = Angle::fromDegrees(2e-9);

[[nodiscard]] bool isSame(const pointing::PointingTerms& a, const pointing::PointingTerms& b,
                          Angle tolerance = kSameTerm);
// Arcs that differ by less than the last digit of a profile count as the same.
[[nodiscard]] bool isSame(const calibration::SensorMounting& a, const calibration::SensorMounting& b);

// The terms of `entered`. A term that differs from `present` only by rounding keeps its exact present value: whoever
// types one term changes only this one.
[[nodiscard]] pointing::PointingTerms changedOnly(pointing::PointingTerms entered,
                                                  const pointing::PointingTerms& present);

}  // namespace boresight
