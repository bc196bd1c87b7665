// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"

// The time of a magnetic model, in years with a fraction: 2026.5 is the middle of 2026, a day is 1/365 or 1/366. Pure.
namespace boresight::geomagnetism {

[[nodiscard]] double decimalYear(UtcTime utc);

}  // namespace boresight::geomagnetism
