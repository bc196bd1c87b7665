// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/sim/console_device.h"

#include <optional>
#include <string>
#include <string_view>

// The commands of the diagnostic console that need no memory of their own: each answers with what the device writes
// back. Pure; `rest` is what follows the command on its line.
namespace boresight::sim::console {

inline constexpr std::string_view kOk = "OK\r\n";

[[nodiscard]] std::string refusal(std::string_view why);  // "ERR …"
// Both cut one word off the front.
[[nodiscard]] std::string_view takeWord(std::string_view& text);
[[nodiscard]] std::optional<double> takeNumber(std::string_view& text);
// Head of a binary block: its length as four bytes.
[[nodiscard]] std::string lengthBytes(std::size_t size);

// `conf …`
[[nodiscard]] std::string config(ConsoleDevice& device, std::string_view command, std::string_view rest);
// `d …`
[[nodiscard]] std::string motion(ConsoleDevice& device, std::string_view command, std::string_view rest);

}  // namespace boresight::sim::console
