// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/numbers.h"
#include "core/base/overloaded.h"
#include "core/profile/profile_file.h"
#include "core/profile/setting.h"
#include "core/records/toml_value.h"

#include <optional>
#include <span>

namespace boresight::profile {

namespace {

std::string inBrackets(const TextList& list)
{
    std::string text;
    for (const std::string& one : list) {
        text += (text.empty() ? "" : ", ") + records::inQuotes(one);
    }
    return "[" + text + "]";
}

template <class Owner>
std::string bounds(const SettingOf<Owner>& setting)
{
    switch (setting.type) {
        case SettingType::Integer:
            return formatFixed(setting.min, 0) + "…" + formatFixed(setting.max, 0);
        case SettingType::Number:
            return records::decimal(setting.min) + "…" + records::decimal(setting.max);
        case SettingType::Choice: {
            std::string text = "one of";
            for (const SettingChoice& one : setting.choices) {
                text += " " + records::inQuotes(one.word);
            }
            return text;
        }
        case SettingType::TextList:
            return "texts";
        case SettingType::Text:
            break;
    }
    return "text";
}

template <class Owner>
std::string boundsAndUnit(const SettingOf<Owner>& setting)
{
    return bounds(setting) + (setting.unit.empty() ? "" : " " + setting.unit);
}

std::string comment(const Setting& setting)
{
    const Profile standard;
    std::string facts = boundsAndUnit(setting);
    facts += setting.assume             ? "; its default depends on other settings"
             : setting.counts(standard) ? "; default " + toText(setting.get(standard))
                                        : "; not given by default, and then nothing else of this table";
    facts += setting.applies == Applies::Now ? "; applies at once" : "; applies on reconnect";
    return "# " + setting.text + "\n# " + facts + "\n";
}

// True if a file without this key would give the same value.
bool isAssumed(const Setting& setting, Profile profile)
{
    const SettingValue value = setting.get(profile);
    if (!setting.assume) {
        return false;
    }
    setting.assume(profile);
    return setting.get(profile) == value;
}

std::string line(const Setting& setting, const Profile& profile)
{
    const std::string key = setting.key.substr(setting.key.find('.') + 1);
    // A key without a value is written as a comment, ready to be filled in.
    return (setting.counts(profile) && !isAssumed(setting, profile) ? "" : "# ") + key + " = " +
           toText(setting.get(profile)) + "\n";
}

std::string horizonText(const std::vector<pointing::HorizonPoint>& horizon)
{
    const auto fields = horizonSettings();
    std::string text =
        "# The horizon seen from the mount: the beam stays at or above the line through these points, "
        "closed through\n# north; [azimuth, elevation], azimuths ascending, each once.\n# " +
        boundsAndUnit(fields[0]) + ", " + boundsAndUnit(fields[1]) + "; default none; applies at once\nhorizon = [";
    for (const pointing::HorizonPoint& point : horizon) {
        text += "\n    [" + toText(fields[0].get(point)) + ", " + toText(fields[1].get(point)) + "],";
    }
    return text + (horizon.empty() ? "]\n" : "\n]\n");
}

std::string keyAndValue(const std::string& key, const SettingValue& value)
{
    return key + " = " + toText(value) + "\n";
}

// `standard`: the value of a key that may be left out.
std::string rowComment(const std::string& key, const std::string& meaning, const std::string& bounds,
                       const std::optional<SettingValue>& standard)
{
    return "#   " + key + ": " + meaning + " " + bounds +
           (standard ? "; default " + toText(*standard) : std::string()) + "\n";
}

template <class Row>
std::string rowText(std::span<const SettingOf<Row>> fields, const Row& row)
{
    std::string text;
    for (const SettingOf<Row>& field : fields) {
        if (!field.mayBeLeftOut || field.get(row) != field.get(Row{})) {
            text += keyAndValue(field.key, field.get(row));
        }
    }
    return text;
}

template <class Row>
std::string rowsText(std::string_view list, const std::string& meaning, std::span<const SettingOf<Row>> fields,
                     const std::vector<Row>& rows)
{
    const std::string head = "[[" + std::string(list) + "]]\n";
    std::string text = "\n# " + meaning + " Each entry begins with " + head;
    for (const SettingOf<Row>& field : fields) {
        const auto standard = field.mayBeLeftOut ? std::optional(field.get(Row{})) : std::nullopt;
        text += rowComment(field.key, field.text, boundsAndUnit(field), standard);
    }
    for (const Row& row : rows) {
        text += "\n" + head + rowText(fields, row);
    }
    return text;
}

// The lists that follow the settings of one table. In TOML all keys of a table are in one place.
std::string listsAfter(const std::string& table, const Profile& profile)
{
    if (table == "mount") {
        return rowsText(kAntennaKey, "Further antennas. The table mount describes the main antenna.", antennaSettings(),
                        profile.antennas);
    }
    if (table == "limits") {
        return horizonText(profile.limits.horizon) +
               rowsText(kKeepOutKey, "Parts of the sky where the beam must not point. The edge is permitted.",
                        keepOutSettings(), profile.limits.keepOuts);
    }
    if (table == "park") {
        return rowsText(kPresetKey, "Directions with a name, for a go-to by one click.", presetSettings(),
                        profile.presets);
    }
    if (table == "orbit") {
        return rowsText(kSatelliteKey, "Notes of the operator about a satellite.", satelliteSettings(),
                        profile.satellites);
    }
    if (table == "schedule") {
        return rowsText(kWatchKey, "Satellites whose passes are tracked while the schedule is armed.", watchSettings(),
                        profile.schedule.watch);
    }
    return {};
}

}  // namespace

std::string toText(const SettingValue& value)
{
    return std::visit(Overloaded{[](const std::string& text) { return records::inQuotes(text); },
                                 [](std::int64_t whole) { return std::to_string(whole); },
                                 [](double real) { return records::decimal(real); },
                                 [](const TextList& list) { return inBrackets(list); }},
                      value);
}

std::string toToml(const Profile& profile)
{
    std::string text =
        "# Boresight mount profile. A key that is left out has its default; an unknown one is an error.\n"
        "# Angles of park, travel and limits are mechanical: 370° is not 10°.\n"
        "version = " +
        std::to_string(kVersion) + "\n";
    std::string table;
    for (const Setting& setting : settings()) {
        const std::size_t dot = setting.key.find('.');
        if (setting.key.substr(0, dot) != table) {
            text += listsAfter(table, profile);
            table = setting.key.substr(0, dot);
            text += "\n[" + table + "]\n";
        }
        text += comment(setting) + line(setting, profile);
    }
    return text;
}

}  // namespace boresight::profile
