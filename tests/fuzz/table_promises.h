// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace boresight::fuzz {

// Holds readTable() and TablePath to what they promise of any text. Accepts a text that is a table.
void feedTable(std::string_view text);

}  // namespace boresight::fuzz
