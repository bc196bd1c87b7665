// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace boresight {

// Of the program, as CMakeLists.txt has it.
inline constexpr std::string_view kVersion = BORESIGHT_VERSION;

}  // namespace boresight
