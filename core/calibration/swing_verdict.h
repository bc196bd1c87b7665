// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/compass_swing.h"

#include <QString>

#include <span>

// Describes the result of a swing in sentences for the operator. Steps of fitCompassSwing(); pure.
namespace boresight::calibration {

// Fills in hints and reasons. `usable`: the samples with which the fit began, in the order of the residuals.
void judge(CompassSwing& swing, std::span<const SwingSample> usable, const SwingLimits& limits);

// Why not even a first harmonic could be fitted.
[[nodiscard]] QString whyTooLittle(const CompassSwing& swing, const SwingLimits& limits);

}  // namespace boresight::calibration
