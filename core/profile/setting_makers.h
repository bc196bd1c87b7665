// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/profile/setting.h"

#include <algorithm>
#include <string>
#include <type_traits>
#include <vector>

// How setting.cpp writes down one setting per line: each maker joins a key and its description to a field of Profile.
// `access` gives that field of a profile, constant or not: [](auto& p) -> auto& { return p.control.tickHz; }.
namespace boresight::profile::makers {

struct Range
{
    double min;
    double max;
};

[[nodiscard]] Result<> checkRange(double value, Range range);
// To the decimals of the file: what is checked is then what will be written and read again.
[[nodiscard]] double rounded(double value);
[[nodiscard]] std::string listed(const std::vector<std::string>& names);  // in quotes, with commas

// Between a typed field and the number in the file, in the unit that the setting names.
inline double toNumber(Angle value)
{
    return value.degrees();
}
inline double toNumber(AngularRate value)
{
    return value.degrees();
}
inline double toNumber(AngularAcceleration value)
{
    return value.degrees();
}
inline double toNumber(AngularJerk value)
{
    return value.degrees();
}
inline double toNumber(Seconds value)
{
    return value.count();
}
inline double toNumber(double value)
{
    return value;
}

template <class Kind, int PerSecond>
void assign(Quantity<Kind, PerSecond>& field, double value)
{
    field = Quantity<Kind, PerSecond>::fromDegrees(value);
}
inline void assign(Seconds& field, double value)
{
    field = Seconds(value);
}
inline void assign(double& field, double value)
{
    field = value;
}

template <class Access>
Setting number(const std::string& key, const std::string& unit, Range range, Applies applies, const std::string& text,
               Access access)
{
    auto get = [access](const Profile& profile) -> SettingValue { return toNumber(access(profile)); };
    auto set = [access, range](Profile& profile, const SettingValue& value) -> Result<> {
        const auto* whole = std::get_if<std::int64_t>(&value);
        const auto* real = std::get_if<double>(&value);
        if (whole == nullptr && real == nullptr) {
            return failure(ErrorCode::InvalidInput, "a number is expected");
        }
        const double wanted = real != nullptr ? *real : static_cast<double>(*whole);
        return checkRange(wanted, range).map([&] { assign(access(profile), rounded(wanted)); });
    };
    return {.key = key,
            .type = SettingType::Number,
            .unit = unit,
            .min = range.min,
            .max = range.max,
            .choices = {},
            .text = text,
            .applies = applies,
            .get = get,
            .set = set};
}

template <class Access>
Setting integer(const std::string& key, const std::string& unit, Range range, Applies applies, const std::string& text,
                Access access)
{
    auto get = [access](const Profile& profile) -> SettingValue { return std::int64_t{access(profile)}; };
    auto set = [access, range](Profile& profile, const SettingValue& value) -> Result<> {
        const auto* whole = std::get_if<std::int64_t>(&value);
        if (whole == nullptr) {
            return failure(ErrorCode::InvalidInput, "a whole number is expected");
        }
        return checkRange(static_cast<double>(*whole), range).map([&] { access(profile) = static_cast<int>(*whole); });
    };
    return {.key = key,
            .type = SettingType::Integer,
            .unit = unit,
            .min = range.min,
            .max = range.max,
            .choices = {},
            .text = text,
            .applies = applies,
            .get = get,
            .set = set};
}

// `names` in the order of the enumerators.
template <class Access>
Setting choice(const std::string& key, const std::vector<std::string>& names, Applies applies, const std::string& text,
               Access access)
{
    auto get = [access, names](const Profile& profile) -> SettingValue {
        return names.at(static_cast<std::size_t>(access(profile)));
    };
    auto set = [access, names](Profile& profile, const SettingValue& value) -> Result<> {
        const auto* wanted = std::get_if<std::string>(&value);
        if (wanted == nullptr) {
            return failure(ErrorCode::InvalidInput, "a text in quotes is expected");
        }
        const auto found = std::find(names.begin(), names.end(), *wanted);
        if (found == names.end()) {
            return failure(ErrorCode::InvalidInput, "\"" + *wanted + "\" is none of " + listed(names));
        }
        auto& field = access(profile);
        field = static_cast<std::remove_reference_t<decltype(field)>>(found - names.begin());
        return {};
    };
    return {.key = key,
            .type = SettingType::Choice,
            .unit = {},
            .choices = names,
            .text = text,
            .applies = applies,
            .get = get,
            .set = set};
}

// `read` turns the profile into the text; `write` takes a text, or says what is wrong with it.
Setting textual(std::string key, Applies applies, std::string text, std::function<std::string(const Profile&)> read,
                std::function<Result<>(Profile&, const std::string&)> write);

}  // namespace boresight::profile::makers
