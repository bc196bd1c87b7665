// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/numbers.h"

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

namespace boresight {
namespace {

template <class Number, class... Options>
std::optional<Number> parseWhole(std::string_view text, Options... options)
{
    if (text.starts_with('+')) {
        text.remove_prefix(1);
        if (text.starts_with('-')) {
            return std::nullopt;
        }
    }
    Number value{};
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value, options...);
    if (error != std::errc{} || stop != end) {
        return std::nullopt;
    }
    return value;
}

bool isNegativeZero(std::string_view digits)
{
    return digits.starts_with('-') && digits.find_first_of("123456789") == std::string_view::npos;
}

}  // namespace

std::optional<double> parseFinite(std::string_view text)
{
    const auto value = parseWhole<double>(text);
    return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<std::int64_t> parseInteger(std::string_view text, int base)
{
    return parseWhole<std::int64_t>(text, base);
}

std::string formatFixed(double value, int decimals)
{
    std::array<char, std::numeric_limits<double>::max_exponent10 + 64> buffer{};
    const auto [end, error] =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, decimals);
    if (error != std::errc{}) {
        return "nan";
    }
    const std::string_view digits(buffer.data(), end);
    return std::string(isNegativeZero(digits) ? digits.substr(1) : digits);
}

}  // namespace boresight
