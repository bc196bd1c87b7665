// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/elements/element_list.h"

#include <string_view>

// Reads element sets in any supported format: TLE, OMM as JSON, CSV, XML or KVN, or the files of Gpredict. The text
// itself shows its format, because file names and content types of servers do not. Pure.
namespace boresight::orbit {

// Larger files and answers are not read. For comparison: 30,000 satellites as JSON take 15 MB.
inline constexpr int kMostElementMegabytes = 64;

enum class ElementForm
{
    Tle,
    Json,
    Csv,
    Xml,
    Kvn,
    Satdata
};

[[nodiscard]] ElementForm elementForm(std::string_view text);
[[nodiscard]] ElementList readElements(std::string_view text);

}  // namespace boresight::orbit
