// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <string_view>

// Reads a power from one line of text, as an S-meter or the program of a receiver sends it. Pure.
namespace boresight::power {

inline constexpr double kLargestPower = 500.0;  // dB, positive or negative: a larger number is not a power

// The power is a number in dB, with a decimal point or a decimal comma: "-73.2", "-73,2 dBm", "RSSI: -73.2". The line
// may also contain words and frequencies in Hz. Other numbers are allowed only if the power has its unit
// ("14074000 -73 dBm"). An ambiguous line, such as "S7" or "14.074 -73", is refused with the reason.
[[nodiscard]] Result<double> parsePower(std::string_view line);

}  // namespace boresight::power
