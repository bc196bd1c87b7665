// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace boresight {

// The version of the program, from CMakeLists.txt.
inline constexpr std::string_view kVersion = BORESIGHT_VERSION;

}  // namespace boresight
