// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognise/sent_points.h"

#include <functional>
#include <optional>

// How well a path in the sky fits the moving points of a client. Each point may be ahead of the path by the lead of the
// client, and all of them by the error of its clock. Pure.
namespace boresight::recognise {

// The direction at a time, as a vector of length 1. Empty: unknown.
using UnitAt = std::function<std::optional<orbit::Vector>(UtcTime)>;

struct MovingFit
{
    double misfit = 0.0;  // 0 for a perfect fit. A difference of kClearly between two misfits is more than chance
    Angle lead;           // how far ahead of the path the points are along it, at most
};

// Empty: the path does not fit.
[[nodiscard]] std::optional<MovingFit> movingFit(const SentPoints& points, const UnitAt& unitAt);

inline constexpr double kClearly = 4.0;

}  // namespace boresight::recognise
