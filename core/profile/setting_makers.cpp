// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/profile/setting_makers.h"

#include "core/base/control_characters.h"
#include "core/base/numbers.h"
#include "core/base/text.h"

#include <QStringList>

#include <cmath>

namespace boresight::profile {

QString choiceName(const std::vector<SettingChoice>& choices, std::string_view word)
{
    const auto found = std::ranges::find(choices, word, &SettingChoice::word);
    return found != choices.end() ? Text::of(found->title) : toQString(word);
}

namespace makers {

namespace {

QString plain(double value)
{
    std::string text = formatFixed(value, 6);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.ends_with('.')) {
        text.pop_back();
    }
    return toQString(text);
}

}  // namespace

Result<> checkRange(double value, Range range)
{
    if (!std::isfinite(value)) {
        return failure(ErrorCode::InvalidInput, Text::tr("a finite number is expected"));
    }
    if (value < range.min || value > range.max) {
        return failure(ErrorCode::OutOfRange,
                       Text::tr("%1 is outside %2…%3").arg(plain(value), plain(range.min), plain(range.max)));
    }
    return {};
}

double rounded(double value)
{
    constexpr double kSteps = 1e9;   // 10 to the power of records::kDecimals
    constexpr double kWhole = 1e15;  // larger values need no rounding, and value * kSteps may overflow
    return std::abs(value) < kWhole ? std::round(value * kSteps) / kSteps : value;
}

QString listed(const std::vector<SettingChoice>& choices)
{
    QStringList list;
    for (const SettingChoice& one : choices) {
        list << QStringLiteral("\"%1\"").arg(toQString(one.word));
    }
    return list.join(QStringLiteral(", "));
}

const std::vector<SettingChoice>& offOn()
{
    static const std::vector<SettingChoice> choices{{"off", QT_TRANSLATE_NOOP("Text", "Off")},
                                                    {"on", QT_TRANSLATE_NOOP("Text", "On")}};
    return choices;
}

const std::vector<SettingChoice>& powerUpChoices()
{
    static const std::vector<SettingChoice> choices{{"ambiguous", QT_TRANSLATE_NOOP("Text", "Ambiguous")},
                                                    {"trusted", QT_TRANSLATE_NOOP("Text", "Trusted")}};
    return choices;
}

Result<> checkName(const std::string& name)
{
    if (name.empty() || name.size() > 60 || hasControlCharacters(name)) {
        return failure(ErrorCode::InvalidInput, Text::tr("one line of 1 to 60 bytes is expected"));
    }
    return {};
}

}  // namespace makers

}  // namespace boresight::profile
