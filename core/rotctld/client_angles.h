// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/units/sky.h"

#include <optional>
#include <string_view>

// Angles as the client of a rotator writes them. Pure.
namespace boresight::rotctld {

// "123.4", "-5", "+7.25", in degrees. Also "123,4", from a program that writes numbers in the language of its user.
[[nodiscard]] std::optional<Angle> degreesIn(std::string_view text);
// OutOfRange: an azimuth outside -3600°…3600° or an elevation outside -90°…180°, which no mount has.
[[nodiscard]] Result<> inReach(Angle azimuth, Angle elevation);

}  // namespace boresight::rotctld
