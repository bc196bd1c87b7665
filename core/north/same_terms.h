// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/calibration_record.h"

// Whether two models, or two mountings of the sensor, differ by more than rounding. Pure.
namespace boresight {

// Half of the last place of what a profile and a history keep, and the rounding of both.
inline constexpr Angle kSameTerm = Angle::fromDegrees(2e-9);

[[nodiscard]] bool isSame(const pointing::PointingTerms& a, const pointing::PointingTerms& b,
                          Angle tolerance = kSameTerm);
// An arc counts as the same within the last place of a profile.
[[nodiscard]] bool isSame(const calibration::SensorMounting& a, const calibration::SensorMounting& b);

// The terms of `entered`. A term that differs from `present` by rounding only keeps its present value exactly: whoever
// types one term changes one.
[[nodiscard]] pointing::PointingTerms changedOnly(pointing::PointingTerms entered,
                                                  const pointing::PointingTerms& present);

}  // namespace boresight
