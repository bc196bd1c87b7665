// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace boresight::fuzz {

// Checks the promises of readTable() and TablePath for any text. Accepts a text that is a table.
void feedTable(std::string_view text);

}  // namespace boresight::fuzz
