// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/targets/target.h"

#include <chrono>

// The reasons against tracking that come from the target itself. The station refuses a target for them, and the screen
// does not offer it. Pure.
namespace boresight::targets {

// The mount waits no longer than this for a target to rise.
inline constexpr std::chrono::minutes kLongestWait{30};

// A mount without a site tracks only targets that need none.
[[nodiscard]] Result<> hasSite(const Target& target, bool isSiteKnown);
// The elements of a satellite must not be older than `oldestDays`. Other targets need no elements.
[[nodiscard]] Result<> isFresh(const Target& target, UtcTime now, double oldestDays);
// The same for elements alone, without the reason.
[[nodiscard]] bool isFresh(const orbit::ElementSet& elements, UtcTime now, double oldestDays);
[[nodiscard]] Result<> isSoon(const QString& name, UtcTime rises, UtcTime now);

}  // namespace boresight::targets
