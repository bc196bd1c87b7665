// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/records/toml_value.h"

#include "core/base/numbers.h"

#include <algorithm>

namespace boresight::records {

std::string inQuotes(std::string_view text)
{
    std::string result = "\"";
    for (const char character : text) {
        if (character == '"' || character == '\\') {
            result += '\\';
        }
        result += character;
    }
    return result + "\"";
}

// A number that is not finite has no decimal point.
std::string decimal(double value)
{
    std::string text = formatFixed(value, kDecimals);
    if (const std::size_t point = text.find('.'); point != std::string::npos) {
        text.erase(std::max(text.find_last_not_of('0'), point + 1) + 1);
    }
    return text;
}

}  // namespace boresight::records
