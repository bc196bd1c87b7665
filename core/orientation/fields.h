// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/orientation/orientation.h"
#include "core/orientation/refusal.h"

#include <cstdint>
#include <string_view>

// The ranges of the sensor's values, for every way in which they arrive. A value that no working sensor can send is
// refused, not clipped. `field` is its name in the refusal. Pure.
namespace boresight::orientation {

// The extended azimuth: finite, with no more turns than a sensor can count in its life.
[[nodiscard]] Parsed<Angle> azimuthOf(double degrees);
[[nodiscard]] Parsed<Angle> elevationOf(double degrees);
[[nodiscard]] Parsed<UtcTime> timeOf(std::int64_t milliseconds);
[[nodiscard]] Parsed<double> temperatureOf(double celsius);
[[nodiscard]] Parsed<int> calibrationDigitOf(std::int64_t digit);

}  // namespace boresight::orientation
