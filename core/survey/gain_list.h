// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/drive_gains.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

// The gains of a drive that may be tuned: how the drive calls them, in which range, and whether it must be off. Pure.
//
// The firmware (bldc_servo.cc, motor_position.h) takes what is below "servo" while it controls. Whatever is below
// "motor_position" begins the count of the encoder again: in a drive that is on this is fault 41, and in each the wrap
// is lost.
namespace boresight::survey {

inline constexpr std::size_t kGainCount = static_cast<std::size_t>(Gain::Count);

// As read; NaN or no number is empty.
using GainValues = std::array<std::optional<double>, kGainCount>;

[[nodiscard]] constexpr std::size_t indexOf(Gain gain)
{
    return static_cast<std::size_t>(gain);
}

[[nodiscard]] const std::string& gainKey(Gain gain);
// The lines without values. The bounds are about the stored values, so that they do not creep with each change.
[[nodiscard]] std::vector<GainLine> gainLines(const GainValues& stored);

}  // namespace boresight::survey
