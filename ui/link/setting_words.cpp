// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/link/setting_words.h"

#include "core/base/numbers.h"
#include "core/base/text.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace boresight::ui {

namespace {

using profile::Setting;
using profile::SettingType;
using profile::SettingValue;

constexpr double kDecades = 1000.0;  // from this ratio on a linear bar would show nothing

struct Title
{
    const char* table;
    const char* title;
};

constexpr Title kTitles[] = {{"mount", QT_TRANSLATE_NOOP("SettingWords", "Mount")},
                             {"bus", QT_TRANSLATE_NOOP("SettingWords", "Bus")},
                             {"azimuth", QT_TRANSLATE_NOOP("SettingWords", "Azimuth axis")},
                             {"elevation", QT_TRANSLATE_NOOP("SettingWords", "Elevation axis")},
                             {"third_axis", QT_TRANSLATE_NOOP("SettingWords", "Third axis")},
                             {"rotator", QT_TRANSLATE_NOOP("SettingWords", "Switched motors")},
                             {"control", QT_TRANSLATE_NOOP("SettingWords", "Control")},
                             {"pointing", QT_TRANSLATE_NOOP("SettingWords", "Pointing model")},
                             {"limits", QT_TRANSLATE_NOOP("SettingWords", "Limits of operation")},
                             {"park", QT_TRANSLATE_NOOP("SettingWords", "Park and presets")},
                             {"site", QT_TRANSLATE_NOOP("SettingWords", "Site")},
                             {"gpredict", QT_TRANSLATE_NOOP("SettingWords", "Gpredict")},
                             {"orbit", QT_TRANSLATE_NOOP("SettingWords", "Satellites")},
                             {"azel", QT_TRANSLATE_NOOP("SettingWords", "Moon by WSJT-X")},
                             {"position", QT_TRANSLATE_NOOP("SettingWords", "Balloon or rocket")},
                             {"schedule", QT_TRANSLATE_NOOP("SettingWords", "Schedule of passes")},
                             {"record", QT_TRANSLATE_NOOP("SettingWords", "Recordings of passes")},
                             {"sun", QT_TRANSLATE_NOOP("SettingWords", "Sun")},
                             {"jog", QT_TRANSLATE_NOOP("SettingWords", "Jog")},
                             {"rotctld", QT_TRANSLATE_NOOP("SettingWords", "rotctld server")},
                             {"listeners", QT_TRANSLATE_NOOP("SettingWords", "Further listeners")},
                             {"clients", QT_TRANSLATE_NOOP("SettingWords", "Clients")},
                             {"supervision", QT_TRANSLATE_NOOP("SettingWords", "Supervision")},
                             {"recovery", QT_TRANSLATE_NOOP("SettingWords", "Recovery")},
                             {"sensor", QT_TRANSLATE_NOOP("SettingWords", "Orientation sensor")},
                             {"mqtt", QT_TRANSLATE_NOOP("SettingWords", "MQTT broker")},
                             {"power", QT_TRANSLATE_NOOP("SettingWords", "Received power")},
                             {"transmit", QT_TRANSLATE_NOOP("SettingWords", "Transmit on target")},
                             {"brake", QT_TRANSLATE_NOOP("SettingWords", "Brake")},
                             {"end_switches", QT_TRANSLATE_NOOP("SettingWords", "End switches")},
                             {"wind", QT_TRANSLATE_NOOP("SettingWords", "Wind")}};

// A setting that has another name on the screen than in the file.
struct Name
{
    std::string_view key;
    const char* name;
};

constexpr Name kNames[] = {{"limits.azimuth_min_deg", QT_TRANSLATE_NOOP("SettingWords", "lowest azimuth")},
                           {"limits.azimuth_max_deg", QT_TRANSLATE_NOOP("SettingWords", "highest azimuth")},
                           {"limits.elevation_min_deg", QT_TRANSLATE_NOOP("SettingWords", "lowest elevation")},
                           {"limits.elevation_max_deg", QT_TRANSLATE_NOOP("SettingWords", "highest elevation")},
                           {"park.azimuth_deg", QT_TRANSLATE_NOOP("SettingWords", "park azimuth")},
                           {"park.elevation_deg", QT_TRANSLATE_NOOP("SettingWords", "park elevation")},
                           {profile::kHorizonKey, QT_TRANSLATE_NOOP("SettingWords", "horizon")},
                           {profile::kKeepOutKey, QT_TRANSLATE_NOOP("SettingWords", "keep-outs")},
                           {profile::kPresetKey, QT_TRANSLATE_NOOP("SettingWords", "presets")},
                           {profile::kSatelliteKey, QT_TRANSLATE_NOOP("SettingWords", "favourites and notes")},
                           {profile::kAntennaKey, QT_TRANSLATE_NOOP("SettingWords", "antennas")},
                           {profile::kWatchKey, QT_TRANSLATE_NOOP("SettingWords", "watch list")},
                           {"site", QT_TRANSLATE_NOOP("SettingWords", "site")}};

class SettingWords
{
    Q_DECLARE_TR_FUNCTIONS(SettingWords)
};

bool isNumber(const Setting& setting)
{
    return setting.type == SettingType::Number || setting.type == SettingType::Integer;
}

QString plain(double value)
{
    return QString::number(value, 'g', 10);
}

QStringList toList(const profile::TextList& texts)
{
    QStringList list;
    for (const std::string& text : texts) {
        list << QString::fromStdString(text);
    }
    return list;
}

QString withoutUnit(const Setting& setting, QString typed)
{
    const QString unit = QString::fromStdString(setting.unit);
    typed = typed.trimmed();
    if (isNumber(setting) && !unit.isEmpty() && typed.endsWith(unit)) {
        typed.chop(unit.size());
    }
    return typed.trimmed();
}

Result<SettingValue> numberOf(const Setting& setting, const QString& typed)
{
    const std::string number = typed.toStdString();
    if (setting.type == SettingType::Integer) {
        if (const auto whole = parseInteger(number)) {
            return SettingValue(*whole);
        }
        return failure(ErrorCode::InvalidInput, SettingWords::tr("\"%1\" is not a whole number.").arg(typed));
    }
    if (const auto real = parseFinite(number)) {
        return SettingValue(*real);
    }
    return failure(
        ErrorCode::InvalidInput,
        SettingWords::tr("\"%1\" is not a number. Type it with a decimal point, for example 113.5.").arg(typed));
}

Result<SettingValue> valueOf(const Setting& setting, const QString& typed)
{
    const QString text = withoutUnit(setting, typed);
    if (isNumber(setting)) {
        return numberOf(setting, text);
    }
    if (setting.type != SettingType::TextList) {
        return SettingValue(text.toStdString());
    }
    profile::TextList list;
    for (const QString& one : text.split(QLatin1Char(','), Qt::SkipEmptyParts)) {
        list.push_back(one.trimmed().toStdString());
    }
    return SettingValue(list);
}

}  // namespace

QString groupTitle(const QString& table)
{
    const auto* const found =
        std::ranges::find_if(kTitles, [&table](const Title& one) { return table == QLatin1String(one.table); });
    return found == std::end(kTitles) ? table : SettingWords::tr(found->title);
}

QString settingName(const std::string& key)
{
    const auto* const found = std::ranges::find(kNames, key, &Name::key);
    if (found != std::end(kNames)) {
        return SettingWords::tr(found->name);
    }
    const QString whole = QString::fromStdString(key);
    if (const Setting* const setting = profile::findSetting(key)) {
        return QStringLiteral("%1 (%2)").arg(Text::of(setting->title),
                                             groupTitle(whole.section(QLatin1Char('.'), 0, 0)));
    }
    const auto dot = whole.indexOf(QLatin1Char('.'));
    return dot < 0 ? whole : QStringLiteral("%1 (%2)").arg(whole.mid(dot + 1), groupTitle(whole.left(dot)));
}

QString problemText(const profile::Problem& problem)
{
    return QStringLiteral("%1: %2").arg(settingName(problem.key), problem.text);
}

QString typedText(const Setting& setting, const profile::Profile& profile)
{
    if (!setting.counts(profile)) {
        return {};
    }
    const SettingValue value = setting.get(profile);
    if (const auto* const text = std::get_if<std::string>(&value)) {
        return QString::fromStdString(*text);
    }
    if (const auto* const list = std::get_if<profile::TextList>(&value)) {
        return toList(*list).join(QStringLiteral(", "));
    }
    return QString::fromStdString(profile::toText(value));
}

QString valueText(const Setting& setting, const profile::Profile& profile)
{
    const QString typed = typedText(setting, profile);
    if (typed.isEmpty()) {
        return setting.type == SettingType::TextList ? SettingWords::tr("none") : SettingWords::tr("not set");
    }
    if (setting.secret) {
        return Text::of(profile::kHidden);
    }
    if (setting.type == SettingType::Choice) {
        return profile::choiceName(setting.choices, typed.toStdString());
    }
    return setting.unit.empty() ? typed : typed + QLatin1Char(' ') + QString::fromStdString(setting.unit);
}

QString rangeText(const Setting& setting)
{
    if (setting.type == SettingType::Choice) {
        QStringList names;
        for (const profile::SettingChoice& one : setting.choices) {
            names << Text::of(one.title);
        }
        return names.join(QStringLiteral(", "));
    }
    if (!isNumber(setting)) {
        return {};
    }
    const QString range = QStringLiteral("%1 … %2").arg(plain(setting.min), plain(setting.max));
    return setting.unit.empty() ? range : range + QLatin1Char(' ') + QString::fromStdString(setting.unit);
}

Result<> putTyped(const Setting& setting, const QString& typed, profile::Profile& profile)
{
    return valueOf(setting, typed)
        .and_then([&](const SettingValue& value) { return setting.set(profile, value); })
        .map_error([&](const Error& error) {
            return Error{error.code, QStringLiteral("%1: %2").arg(Text::of(setting.title), error.text)};
        });
}

std::optional<double> shareOfRange(const Setting& setting, const profile::Profile& profile)
{
    if (!isNumber(setting) || !setting.counts(profile) || !(setting.max > setting.min)) {
        return std::nullopt;
    }
    const SettingValue held = setting.get(profile);
    const auto* const whole = std::get_if<std::int64_t>(&held);
    const double value = whole != nullptr ? static_cast<double>(*whole) : std::get<double>(held);
    const bool byLogarithm = setting.min > 0.0 && setting.max / setting.min >= kDecades && value > 0.0;
    const double share = byLogarithm ? std::log(value / setting.min) / std::log(setting.max / setting.min)
                                     : (value - setting.min) / (setting.max - setting.min);
    return std::clamp(share, 0.0, 1.0);
}

}  // namespace boresight::ui
