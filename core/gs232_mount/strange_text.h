// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace boresight::gs232 {

// The beginning of what a device sent in place of an answer, printable.
[[nodiscard]] std::string shownOfStrange(std::string_view bytes);

}  // namespace boresight::gs232
