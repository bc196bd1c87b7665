// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/sky.h"

#include <algorithm>

// Ranges of angles and their comparison, for all shapes on the sky. Pure.
namespace boresight::pointing {

inline constexpr Angle kFullTurn = Angle::fromTurns(1.0);
// Two ways to compute the same angle differ by less than this. The end of a travel counts as inside.
inline constexpr Angle kRounding = Angle::fromDegrees(1e-9);
inline constexpr Angle kBeyond = Angle::fromDegrees(3600.0);  // farther than any axis turns

[[nodiscard]] inline TravelRange common(const TravelRange& a, const TravelRange& b)
{
    return {.min = std::max(a.min, b.min), .max = std::min(a.max, b.max)};
}

[[nodiscard]] inline bool reaches(const TravelRange& range, Angle angle)
{
    return angle >= range.min - kRounding && angle <= range.max + kRounding;
}

}  // namespace boresight::pointing
