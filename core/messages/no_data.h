// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

// When a reading is too old to be one: the station reports no data then, and the screen shows no number any more.
namespace boresight {

inline constexpr std::chrono::milliseconds kNoDataAfter{2000};

}  // namespace boresight
