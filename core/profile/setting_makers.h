// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/text.h"
#include "core/profile/setting.h"
#include "core/records/field_list.h"

#include <algorithm>
#include <string>
#include <type_traits>
#include <vector>

// Functions that describe one setting each: a key, a description and the field of its owner. The owner is a Profile or
// one row of a list. `access` returns the field, constant or not: [](auto& p) -> auto& { return p.control.tickHz; }.
namespace boresight::profile::makers {

inline constexpr auto kNow = Applies::Now;

using records::Range;

// The texts about a setting, in English. Text::of() translates them for the screen.
struct Words
{
    std::string title;    // two or three words, as on the page of the profile
    std::string meaning;  // full sentences
};

[[nodiscard]] Result<> checkRange(double value, Range range);
// Rounds to the decimals of the file, so that the checked value is the value that is written and read again.
[[nodiscard]] double rounded(double value);
[[nodiscard]] QString listed(const std::vector<std::string>& names);  // in quotes, with commas

// Convert between a typed field and the number in the file. The number has the unit that the setting names.
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

template <class Owner = Profile, class Access>
SettingOf<Owner> number(const std::string& key, const std::string& unit, Range range, Applies applies,
                        const Words& words, Access access)
{
    auto get = [access](const Owner& owner) -> SettingValue { return toNumber(access(owner)); };
    auto set = [access, range](Owner& owner, const SettingValue& value) -> Result<> {
        const auto* whole = std::get_if<std::int64_t>(&value);
        const auto* real = std::get_if<double>(&value);
        if (whole == nullptr && real == nullptr) {
            return failure(ErrorCode::InvalidInput, Text::tr("a number is expected"));
        }
        const double wanted = rounded(real != nullptr ? *real : static_cast<double>(*whole));
        return checkRange(wanted, range).map([&] { assign(access(owner), wanted); });
    };
    return {.key = key,
            .title = words.title,
            .type = SettingType::Number,
            .unit = unit,
            .min = range.min,
            .max = range.max,
            .choices = {},
            .text = words.meaning,
            .applies = applies,
            .get = get,
            .set = set};
}

template <class Owner = Profile, class Access>
SettingOf<Owner> integer(const std::string& key, const std::string& unit, Range range, Applies applies,
                         const Words& words, Access access)
{
    auto get = [access](const Owner& owner) -> SettingValue { return std::int64_t{access(owner)}; };
    auto set = [access, range](Owner& owner, const SettingValue& value) -> Result<> {
        const auto* whole = std::get_if<std::int64_t>(&value);
        if (whole == nullptr) {
            return failure(ErrorCode::InvalidInput, Text::tr("a whole number is expected"));
        }
        return checkRange(static_cast<double>(*whole), range).map([&] { access(owner) = static_cast<int>(*whole); });
    };
    return {.key = key,
            .title = words.title,
            .type = SettingType::Integer,
            .unit = unit,
            .min = range.min,
            .max = range.max,
            .choices = {},
            .text = words.meaning,
            .applies = applies,
            .get = get,
            .set = set};
}

// `names`: one per enumerator, in the same order.
template <class Owner = Profile, class Access>
SettingOf<Owner> choice(const std::string& key, const std::vector<std::string>& names, Applies applies,
                        const Words& words, Access access)
{
    auto get = [access, names](const Owner& owner) -> SettingValue {
        return names.at(static_cast<std::size_t>(access(owner)));
    };
    auto set = [access, names](Owner& owner, const SettingValue& value) -> Result<> {
        const auto* wanted = std::get_if<std::string>(&value);
        if (wanted == nullptr) {
            return failure(ErrorCode::InvalidInput, Text::tr("a text in quotes is expected"));
        }
        const auto found = std::find(names.begin(), names.end(), *wanted);
        if (found == names.end()) {
            return failure(ErrorCode::InvalidInput,
                           Text::tr("\"%1\" is not one of %2").arg(toQString(*wanted), listed(names)));
        }
        auto& field = access(owner);
        field = static_cast<std::remove_reference_t<decltype(field)>>(found - names.begin());
        return {};
    };
    return {.key = key,
            .title = words.title,
            .type = SettingType::Choice,
            .unit = {},
            .choices = names,
            .text = words.meaning,
            .applies = applies,
            .get = get,
            .set = set};
}

// `read` returns the text of the owner. `write` sets the text, or returns what is wrong with it.
template <class Owner = Profile, class Read, class Write>
SettingOf<Owner> textual(const std::string& key, Applies applies, const Words& words, Read read, Write write)
{
    auto set = [write](Owner& owner, const SettingValue& value) -> Result<> {
        const auto* wanted = std::get_if<std::string>(&value);
        return wanted != nullptr ? Result<>(write(owner, *wanted))
                                 : failure(ErrorCode::InvalidInput, Text::tr("a text in quotes is expected"));
    };
    return {.key = key,
            .title = words.title,
            .type = SettingType::Text,
            .unit = {},
            .choices = {},
            .text = words.meaning,
            .applies = applies,
            .get = [read](const Owner& owner) -> SettingValue { return read(owner); },
            .set = set};
}

// Checks a name that people read: one line, not empty.
[[nodiscard]] Result<> checkName(const std::string& name);

template <class Owner = Profile, class Access>
SettingOf<Owner> name(const std::string& key, Applies applies, const Words& words, Access access)
{
    return textual<Owner>(
        key, applies, words, [access](const Owner& owner) { return access(owner); },
        [access](Owner& owner, const std::string& wanted) {
            return checkName(wanted).map([&] { access(owner) = wanted; });
        });
}

// `check` returns what is wrong with one text of the list.
template <class Owner = Profile, class Access>
SettingOf<Owner> textList(const std::string& key, Applies applies, const Words& words, Access access,
                          Result<> (*check)(const std::string&))
{
    auto set = [access, check](Owner& owner, const SettingValue& value) -> Result<> {
        const auto* wanted = std::get_if<TextList>(&value);
        if (wanted == nullptr) {
            return failure(ErrorCode::InvalidInput,
                           Text::tr("a list of texts in quotes is expected, like [\"one\", \"two\"]"));
        }
        for (const std::string& one : *wanted) {
            if (const auto fits = check(one); !fits) {
                return fits;
            }
        }
        access(owner) = *wanted;
        return {};
    };
    return {.key = key,
            .title = words.title,
            .type = SettingType::TextList,
            .unit = {},
            .choices = {},
            .text = words.meaning,
            .applies = applies,
            .get = [access](const Owner& owner) -> SettingValue { return access(owner); },
            .set = set};
}

// A key of a row that a file may leave out. It then has the default of the row.
template <class Row>
SettingOf<Row> mayBeLeftOut(SettingOf<Row> setting)
{
    setting.mayBeLeftOut = true;
    return setting;
}

}  // namespace boresight::profile::makers
