// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/elements/element_list.h"

#include <string_view>

// Element sets in any of the forms that we read: TLE, OMM as JSON, CSV, XML or KVN, or what Gpredict keeps. The text
// itself shows which one it is, since names of files and types of servers do not. Pure.
namespace boresight::orbit {

// Larger files and answers are not read. 30,000 satellites as JSON: 15 MB.
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
