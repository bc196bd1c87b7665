// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/sim/console_device.h"

#include <optional>
#include <string>
#include <string_view>

// The commands of the diagnostic console that keep no state. Each returns the answer of the device. Pure. `rest` is the
// part of the line after the command.
namespace boresight::sim::console {

inline constexpr std::string_view kOk = "OK\r\n";

[[nodiscard]] std::string refusal(std::string_view why);  // "ERR …"
// Both remove one word from the front of `text` and return it.
[[nodiscard]] std::string_view takeWord(std::string_view& text);
[[nodiscard]] std::optional<double> takeNumber(std::string_view& text);
// The head of a binary block: its length in four bytes.
[[nodiscard]] std::string lengthBytes(std::size_t size);

// `conf …`
[[nodiscard]] std::string config(ConsoleDevice& device, std::string_view command, std::string_view rest);
// `d …`
[[nodiscard]] std::string motion(ConsoleDevice& device, std::string_view command, std::string_view rest);

}  // namespace boresight::sim::console
