// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotctld/c_number.h"

#include <charconv>
#include <cmath>
#include <string>
#include <system_error>

namespace boresight::rotctld {
namespace {

bool dropSign(std::string_view& text)
{
    const bool negative = text.starts_with('-');
    if (negative || text.starts_with('+')) {
        text.remove_prefix(1);
    }
    return negative;
}

template <class Number>
std::optional<Number> leadingFloat(std::string_view text)
{
    const bool negative = dropSign(text);
    auto format = std::chars_format::general;
    if (text.starts_with("0x") || text.starts_with("0X")) {
        text.remove_prefix(2);
        format = std::chars_format::hex;
    }
    if (text.starts_with('-')) {
        return std::nullopt;  // "--5": from_chars would accept the second sign
    }
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, format);
    if (error != std::errc{} || !std::isfinite(value)) {
        return std::nullopt;
    }
    return negative ? -value : value;
}

}  // namespace

std::optional<double> leadingDouble(std::string_view text)
{
    return leadingFloat<double>(text);
}

std::optional<float> leadingPosition(std::string_view text)
{
    const std::size_t comma = text.find(',');
    if (comma == std::string_view::npos) {
        return leadingFloat<float>(text);
    }
    std::string withPoint(text);
    withPoint[comma] = '.';
    return leadingFloat<float>(withPoint);
}

std::optional<int> leadingInteger(std::string_view text)
{
    if (text.starts_with('+')) {
        text.remove_prefix(1);
        if (text.starts_with('-')) {
            return std::nullopt;
        }
    }
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc{} ? std::optional(value) : std::nullopt;
}

}  // namespace boresight::rotctld
