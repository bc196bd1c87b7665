// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/elements/element_list.h"

#include <string_view>

// A text of two-line and three-line element sets in any mixture. The name before a set may begin with "0 ". Empty lines
// and lines that begin with "#" are ignored. Pure.
namespace boresight::orbit {

[[nodiscard]] ElementList readTle(std::string_view text);

}  // namespace boresight::orbit
