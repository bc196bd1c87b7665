// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/drive_gains.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

// The gains of a drive that may be tuned: the key in the drive, the permitted range, and whether the drive must be off.
// Pure.
//
// The firmware (bldc_servo.cc, motor_position.h) accepts settings below "servo" while it controls. A change below
// "motor_position" starts the count of the encoder again. In a drive that is on, this causes fault 41. In every drive
// the wrap is lost.
namespace boresight::drive_check {

inline constexpr std::size_t kGainCount = static_cast<std::size_t>(Gain::Count);

// As read. Empty for NaN, or if the text is no number.
using GainValues = std::array<std::optional<double>, kGainCount>;

[[nodiscard]] constexpr std::size_t indexOf(Gain gain)
{
    return static_cast<std::size_t>(gain);
}

[[nodiscard]] const std::string& gainKey(Gain gain);
// The lines without values. The bounds depend on the stored values, so they do not move with each change.
[[nodiscard]] std::vector<GainLine> gainLines(const GainValues& stored);

}  // namespace boresight::drive_check
