// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotctl/hamlib_setting.h"

#include "core/base/numbers.h"
#include "core/base/text.h"

#include <algorithm>
#include <array>
#include <utility>

namespace boresight::rotctl {
namespace {

constexpr std::size_t kLongestSetting = 100;

// What Boresight tells rotctld itself, and the key of the profile for it.
constexpr std::array<std::pair<std::string_view, std::string_view>, 2> kOfBoresight{
    std::pair{"rot_pathname", "bus.name"}, std::pair{"serial_speed", "bus.baud"}};
constexpr std::array<std::string_view, 4> kLimits{"min_az", "max_az", "min_el", "max_el"};

bool isSmallLetter(char one)
{
    return one >= 'a' && one <= 'z';
}

// Hamlib also accepts the number of a setting in place of its name.
bool isNameOfHamlib(std::string_view name)
{
    return !name.empty() && isSmallLetter(name.front()) && std::ranges::all_of(name, [](char one) {
        return one == '_' || isSmallLetter(one) || (one >= '0' && one <= '9');
    });
}

// rotctld separates settings by commas.
bool isValueOfHamlib(std::string_view value)
{
    return !value.empty() &&
           std::ranges::all_of(value, [](char one) { return one > ' ' && one < '\x7f' && one != ',' && one != '='; });
}

}  // namespace

Result<HamlibSetting> parseHamlibSetting(std::string_view text)
{
    const auto equals = text.find('=');
    const std::string_view name = text.substr(0, equals);
    const std::string_view value = equals == std::string_view::npos ? std::string_view() : text.substr(equals + 1);
    if (text.size() > kLongestSetting || !isNameOfHamlib(name) || !isValueOfHamlib(value)) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("NAME=VALUE without blanks and commas is expected, like \"min_az=-90\""));
    }
    const auto* const own = std::ranges::find(kOfBoresight, name, &decltype(kOfBoresight)::value_type::first);
    if (own != kOfBoresight.end()) {
        return failure(
            ErrorCode::InvalidInput,
            Text::tr("Boresight sets %1 itself. Change %2 instead").arg(toQString(name), toQString(own->second)));
    }
    if (std::ranges::find(kLimits, name) != kLimits.end() && !parseFinite(value)) {
        return failure(ErrorCode::InvalidInput, Text::tr("%1 needs a number").arg(toQString(name)));
    }
    return HamlibSetting{.name = std::string(name), .value = std::string(value)};
}

}  // namespace boresight::rotctl
