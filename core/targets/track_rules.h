// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/targets/target.h"

#include <chrono>

// What of the target itself is in the way of tracking it now. The station refuses by these rules, and the screen offers
// nothing that they refuse. Pure.
namespace boresight::targets {

// The mount waits no longer than this for a target to rise.
inline constexpr std::chrono::minutes kLongestWait{30};

// The mount knows its place, or the target needs none.
[[nodiscard]] Result<> hasSite(const Target& target, bool isSiteKnown);
// Of a satellite: its elements are not older than this. All else needs no elements.
[[nodiscard]] Result<> isFresh(const Target& target, UtcTime now, double oldestDays);
[[nodiscard]] Result<> isSoon(const QString& name, UtcTime rises, UtcTime now);

}  // namespace boresight::targets
