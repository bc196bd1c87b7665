// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/text.h"
#include "core/profile/setting.h"
#include "core/records/field_list.h"

#include <algorithm>
#include <functional>
#include <string>
#include <string_view>
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
    const char* title;    // two or three words, as on the page of the profile
    const char* meaning;  // full sentences
};

[[nodiscard]] Result<> checkRange(double value, Range range);
// Rounds to the decimals of the file, so that the checked value is the value that is written and read again.
[[nodiscard]] double rounded(double value);
[[nodiscard]] QString listed(const std::vector<SettingChoice>& choices);  // their words in quotes, with commas
// The choices of a switch: "off" and "on".
[[nodiscard]] const std::vector<SettingChoice>& offOn();
// The choices for the position of an axis after power-up.
[[nodiscard]] const std::vector<SettingChoice>& powerUpChoices();

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

// How a setting reads and writes its field. The same code serves the fields of one kind, so that the compiler does not
// repeat it for each of several hundred settings.
template <class Owner, class Value>
struct Field
{
    std::function<Value(const Owner&)> read;
    std::function<void(Owner&, const Value&)> write;
};

template <class Owner>
SettingOf<Owner> described(std::string_view key, SettingType type, Applies applies, const Words& words)
{
    SettingOf<Owner> setting;
    setting.key = key;
    setting.title = words.title;
    setting.type = type;
    setting.text = words.meaning;
    setting.applies = applies;
    return setting;
}

template <class Owner>
SettingOf<Owner> numberOf(std::string_view key, std::string_view unit, Range range, Applies applies, const Words& words,
                          const Field<Owner, double>& field)
{
    SettingOf<Owner> setting = described<Owner>(key, SettingType::Number, applies, words);
    setting.unit = unit;
    setting.min = range.min;
    setting.max = range.max;
    setting.get = [read = field.read](const Owner& owner) -> SettingValue { return read(owner); };
    setting.set = [write = field.write, range](Owner& owner, const SettingValue& value) -> Result<> {
        const auto* whole = std::get_if<std::int64_t>(&value);
        const auto* real = std::get_if<double>(&value);
        if (whole == nullptr && real == nullptr) {
            return failure(ErrorCode::InvalidInput, Text::tr("a number is expected"));
        }
        const double wanted = rounded(real != nullptr ? *real : static_cast<double>(*whole));
        return checkRange(wanted, range).map([&] { write(owner, wanted); });
    };
    return setting;
}

template <class Owner = Profile, class Access>
SettingOf<Owner> number(std::string_view key, std::string_view unit, Range range, Applies applies, const Words& words,
                        Access access)
{
    return numberOf<Owner>(key, unit, range, applies, words,
                           {.read = [access](const Owner& owner) { return toNumber(access(owner)); },
                            .write = [access](Owner& owner, double value) { assign(access(owner), value); }});
}

template <class Owner>
SettingOf<Owner> integerOf(std::string_view key, std::string_view unit, Range range, Applies applies,
                           const Words& words, const Field<Owner, int>& field)
{
    SettingOf<Owner> setting = described<Owner>(key, SettingType::Integer, applies, words);
    setting.unit = unit;
    setting.min = range.min;
    setting.max = range.max;
    setting.get = [read = field.read](const Owner& owner) -> SettingValue { return std::int64_t{read(owner)}; };
    setting.set = [write = field.write, range](Owner& owner, const SettingValue& value) -> Result<> {
        const auto* whole = std::get_if<std::int64_t>(&value);
        if (whole == nullptr) {
            return failure(ErrorCode::InvalidInput, Text::tr("a whole number is expected"));
        }
        return checkRange(static_cast<double>(*whole), range).map([&] { write(owner, static_cast<int>(*whole)); });
    };
    return setting;
}

template <class Owner = Profile, class Access>
SettingOf<Owner> integer(std::string_view key, std::string_view unit, Range range, Applies applies, const Words& words,
                         Access access)
{
    return integerOf<Owner>(key, unit, range, applies, words,
                            {.read = [access](const Owner& owner) { return int{access(owner)}; },
                             .write = [access](Owner& owner, int value) { access(owner) = value; }});
}

template <class Owner>
SettingOf<Owner> choiceOf(std::string_view key, const std::vector<SettingChoice>& choices, Applies applies,
                          const Words& words, const Field<Owner, std::size_t>& field)
{
    SettingOf<Owner> setting = described<Owner>(key, SettingType::Choice, applies, words);
    setting.choices = choices;
    setting.get = [choices, read = field.read](const Owner& owner) -> SettingValue {
        return choices.at(read(owner)).word;
    };
    setting.set = [choices, write = field.write](Owner& owner, const SettingValue& value) -> Result<> {
        const auto* wanted = std::get_if<std::string>(&value);
        if (wanted == nullptr) {
            return failure(ErrorCode::InvalidInput, Text::tr("a text in quotes is expected"));
        }
        const auto found = std::ranges::find(choices, *wanted, &SettingChoice::word);
        if (found == choices.end()) {
            return failure(ErrorCode::InvalidInput,
                           Text::tr("\"%1\" is not one of %2").arg(toQString(*wanted), listed(choices)));
        }
        write(owner, static_cast<std::size_t>(found - choices.begin()));
        return {};
    };
    return setting;
}

// `choices`: one per enumerator, in the same order.
template <class Owner = Profile, class Access>
SettingOf<Owner> choice(std::string_view key, const std::vector<SettingChoice>& choices, Applies applies,
                        const Words& words, Access access)
{
    return choiceOf<Owner>(key, choices, applies, words,
                           {.read = [access](const Owner& owner) { return static_cast<std::size_t>(access(owner)); },
                            .write =
                                [access](Owner& owner, std::size_t index) {
                                    auto& field = access(owner);
                                    field = static_cast<std::remove_reference_t<decltype(field)>>(index);
                                }});
}

// `read` returns the text of the owner. `write` sets the text, or returns what is wrong with it.
template <class Owner = Profile>
SettingOf<Owner> textual(std::string_view key, Applies applies, const Words& words,
                         const std::type_identity_t<std::function<std::string(const Owner&)>>& read,
                         const std::type_identity_t<std::function<Result<>(Owner&, const std::string&)>>& write)
{
    SettingOf<Owner> setting = described<Owner>(key, SettingType::Text, applies, words);
    setting.get = [read](const Owner& owner) -> SettingValue { return read(owner); };
    setting.set = [write](Owner& owner, const SettingValue& value) -> Result<> {
        const auto* wanted = std::get_if<std::string>(&value);
        return wanted != nullptr ? write(owner, *wanted)
                                 : failure(ErrorCode::InvalidInput, Text::tr("a text in quotes is expected"));
    };
    return setting;
}

// Checks a name that people read: one line, not empty.
[[nodiscard]] Result<> checkName(const std::string& name);

template <class Owner = Profile, class Access>
SettingOf<Owner> name(std::string_view key, Applies applies, const Words& words, Access access)
{
    return textual<Owner>(
        key, applies, words, [access](const Owner& owner) { return access(owner); },
        [access](Owner& owner, const std::string& wanted) {
            return checkName(wanted).map([&] { access(owner) = wanted; });
        });
}

template <class Owner>
SettingOf<Owner> textListOf(std::string_view key, Applies applies, const Words& words,
                            const Field<Owner, TextList>& field, Result<> (*check)(const std::string&))
{
    SettingOf<Owner> setting = described<Owner>(key, SettingType::TextList, applies, words);
    setting.get = [read = field.read](const Owner& owner) -> SettingValue { return read(owner); };
    setting.set = [write = field.write, check](Owner& owner, const SettingValue& value) -> Result<> {
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
        write(owner, *wanted);
        return {};
    };
    return setting;
}

// `check` returns what is wrong with one text of the list.
template <class Owner = Profile, class Access>
SettingOf<Owner> textList(std::string_view key, Applies applies, const Words& words, Access access,
                          Result<> (*check)(const std::string&))
{
    return textListOf<Owner>(key, applies, words,
                             {.read = [access](const Owner& owner) { return access(owner); },
                              .write = [access](Owner& owner, const TextList& value) { access(owner) = value; }},
                             check);
}

// A key of a row that a file may leave out. It then has the default of the row.
template <class Row>
SettingOf<Row> mayBeLeftOut(SettingOf<Row> setting)
{
    setting.mayBeLeftOut = true;
    return setting;
}

}  // namespace boresight::profile::makers
