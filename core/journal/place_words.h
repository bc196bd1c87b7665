// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/units/quantity.h"

#include <QString>

// Angles and times as texts for the operator. Pure.
namespace boresight::journal {

[[nodiscard]] QString inWords(Angle angle);   // "405.0°"
[[nodiscard]] QString inWords(Seconds time);  // "34 s", "12 min", "5 h", "3 days"

}  // namespace boresight::journal
