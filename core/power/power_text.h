// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <string_view>

// A power as an S-meter or a receiver's program tells it, in one line. Pure.
namespace boresight::power {

inline constexpr double kLargestPower = 500.0;  // dB, either way: more is no power

// A number in dB, with a point or one comma: "-73.2", "-73,2 dBm", "RSSI: -73.2". Beside it a line may have words, and
// numbers with Hz; other numbers only if the power's own has its unit ("14074000 -73 dBm"). What is not sure, as "S7"
// or "14.074 -73", is refused with the reason.
[[nodiscard]] Result<double> parsePower(std::string_view line);

}  // namespace boresight::power
