// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

// Text like "<PST><AZIMUTH>85</AZIMUTH></PST>": XML tags without attributes. Entities are not resolved. Pure.
namespace boresight::udp {

inline constexpr std::size_t kMostFields = 16;

struct Field
{
    std::string_view name;
    std::string_view value;  // without blanks at both ends
};

// The text between "<tag>" at its beginning and "</tag>" at its end. Blanks and an XML declaration may come first.
[[nodiscard]] std::optional<std::string_view> bodyOf(std::string_view text, std::string_view tag);
// The text in the first "<tag>…</tag>".
[[nodiscard]] std::optional<std::string_view> valueOf(std::string_view text, std::string_view tag);
// The fields of "<a>1</a> <b>2</b>", none inside another. Empty for any other text, and for more than kMostFields.
[[nodiscard]] std::optional<std::vector<Field>> fieldsIn(std::string_view body);

}  // namespace boresight::udp
