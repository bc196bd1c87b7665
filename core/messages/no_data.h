// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

// The age from which a reading is too old. Then the station reports no data, and the screen shows no number.
namespace boresight {

inline constexpr std::chrono::milliseconds kNoDataAfter{2000};

}  // namespace boresight
