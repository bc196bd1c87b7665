// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/profile/profile_diff.h"

#include "core/base/text.h"

#include <QStringList>

#include <algorithm>
#include <array>
#include <functional>
#include <set>
#include <string_view>

namespace boresight::profile {

namespace {

// The functions to compare, show and copy the value of one key.
struct Item
{
    std::string key;
    Applies applies = Applies::Now;
    std::function<std::string(const Profile&)> written;  // the text in the file, for comparing
    std::function<QString(const Profile& shown, const Profile& other)> text;
    std::function<void(Profile& into, const Profile& from)> take;
};

template <class Owner>
QString withUnit(const SettingOf<Owner>& setting, const Owner& owner)
{
    return toQString(toText(setting.get(owner)) + (setting.unit.empty() ? "" : " " + setting.unit));
}

QString shownText(const Setting& setting, const Profile& profile)
{
    const bool hide = setting.secret && setting.get(profile) != SettingValue(std::string());
    return hide ? Text::of(kHidden) : withUnit(setting, profile);
}

Item itemOf(const Setting& setting)
{
    return {.key = setting.key,
            .applies = setting.applies,
            .written = [&setting](const Profile& profile) { return toText(setting.get(profile)); },
            .text = [&setting](const Profile& shown, const Profile&) { return shownText(setting, shown); },
            .take = [&setting](Profile& into, const Profile& from) { (void)setting.set(into, setting.get(from)); }};
}

constexpr std::array kSiteKeys{"site.latitude_deg", "site.longitude_deg", "site.height_m"};

std::string writtenSite(const Profile& profile)
{
    std::string text;
    for (const char* const key : kSiteKeys) {
        text += profile.site.known ? toText(findSetting(key)->get(profile)) + " " : "";
    }
    return text;
}

QString siteText(const Profile& profile)
{
    if (!profile.site.known) {
        return Text::tr("not set");
    }
    QStringList parts;
    for (const char* const key : kSiteKeys) {
        parts << withUnit(*findSetting(key), profile);
    }
    return parts.join(QStringLiteral(", "));
}

Item siteItem()
{
    return {.key = "site",
            .applies = Applies::Now,
            .written = writtenSite,
            .text = [](const Profile& shown, const Profile&) { return siteText(shown); },
            .take = [](Profile& into, const Profile& from) { into.site = from.site; }};
}

template <class Row>
std::string writtenRow(std::span<const SettingOf<Row>> fields, const Row& row)
{
    std::string text;
    for (const SettingOf<Row>& field : fields) {
        text += toText(field.get(row)) + " ";
    }
    return text;
}

// `rows` returns the list of a profile, constant or not. `text` lists the rows, and how they differ from the other
// list.
template <class Row, class Rows>
Item listItem(std::string_view key, std::span<const SettingOf<Row>> fields, Rows rows,
              QString (*text)(const std::vector<Row>& shown, const std::vector<Row>& others))
{
    return {.key = std::string(key),
            .applies = Applies::Now,
            .written =
                [fields, rows](const Profile& profile) {
                    std::string all;
                    for (const Row& row : rows(profile)) {
                        all += writtenRow(fields, row) + "\n";
                    }
                    return all;
                },
            .text = [rows, text](const Profile& shown, const Profile& other) { return text(rows(shown), rows(other)); },
            .take = [rows](Profile& into, const Profile& from) { rows(into) = rows(from); }};
}

QString horizonText(const std::vector<pointing::HorizonPoint>& shown, const std::vector<pointing::HorizonPoint>& others)
{
    const QString count = shown.size() == 1 ? Text::tr("1 point") : Text::tr("%1 points").arg(shown.size());
    if (shown.size() != others.size()) {
        return count;
    }
    const auto moved =
        std::ranges::count_if(shown, [&](const auto& point) { return std::ranges::count(others, point) == 0; });
    return Text::tr("%1, %2 different").arg(count, QString::number(moved));
}

// The names of the rows. A row is marked if the other list has a different row of this name.
template <class Row>
QString namesText(const std::vector<Row>& shown, const std::vector<Row>& others)
{
    QStringList names;
    for (const Row& row : shown) {
        const bool isNamed = std::ranges::count(others, row.name, &Row::name) > 0;
        const bool isAlike = std::ranges::count(others, row) > 0;
        names << toQString(toText(row.name)) + (isNamed && !isAlike ? u' ' + Text::tr("(different)") : QString());
    }
    return names.isEmpty() ? Text::tr("none") : names.join(QStringLiteral(", "));
}

// The same for rows that are identified by the number of a satellite.
template <class Row>
QString numbersText(const std::vector<Row>& shown, const std::vector<Row>& others)
{
    QStringList numbers;
    for (const Row& row : shown) {
        const bool isListed = std::ranges::count(others, row.number, &Row::number) > 0;
        const bool isAlike = std::ranges::count(others, row) > 0;
        numbers << QString::number(row.number) + (isListed && !isAlike ? u' ' + Text::tr("(different)") : QString());
    }
    return numbers.isEmpty() ? Text::tr("none") : numbers.join(QStringLiteral(", "));
}

std::vector<Item> makeItems()
{
    std::vector<Item> items;
    for (const Setting& setting : settings()) {
        if (!setting.isGiven) {
            items.push_back(itemOf(setting));
        }
        // The lists follow where they are in the file.
        if (setting.key == "limits.elevation_max_deg") {
            items.push_back(listItem(
                kHorizonKey, horizonSettings(), [](auto& p) -> auto& { return p.limits.horizon; }, &horizonText));
            items.push_back(listItem(
                kKeepOutKey, keepOutSettings(), [](auto& p) -> auto& { return p.limits.keepOuts; },
                &namesText<pointing::KeepOut>));
        } else if (setting.key == "park.after_min") {
            items.push_back(listItem(
                kPresetKey, presetSettings(), [](auto& p) -> auto& { return p.presets; }, &namesText<Preset>));
            items.push_back(siteItem());
        } else if (setting.key == "mount.directions") {
            items.push_back(listItem(
                kAntennaKey, antennaSettings(), [](auto& p) -> auto& { return p.antennas; },
                &namesText<pointing::Antenna>));
        } else if (setting.key == "orbit.refraction") {
            items.push_back(listItem(
                kSatelliteKey, satelliteSettings(), [](auto& p) -> auto& { return p.satellites; },
                &numbersText<orbit::SatelliteMark>));
        } else if (setting.key == "schedule.unattended") {
            items.push_back(listItem(
                kWatchKey, watchSettings(), [](auto& p) -> auto& { return p.schedule.watch; },
                &numbersText<schedule::WatchEntry>));
        }
    }
    return items;
}

const std::vector<Item>& items()
{
    static const std::vector<Item> list = makeItems();
    return list;
}

bool differs(const Item& item, const Profile& a, const Profile& b)
{
    return item.written(a) != item.written(b);
}

// The settings of one group are applied together or not at all. "limits" is the group of "limits.horizon" and
// "keep_out[2].name".
std::string groupOf(std::string_view key)
{
    const std::string table(key.substr(0, key.find_first_of(".[")));
    return table == kKeepOutKey ? "limits" : table;
}

// Applies `wanted`, but keeps the old values of the differing keys that `waits` selects.
template <class Waits>
Application applyBut(const Profile& inForce, const Profile& wanted, Waits waits)
{
    Application result{.inForce = wanted, .waitingKeys = {}};
    for (const Item& item : items()) {
        if (waits(item) && differs(item, inForce, wanted)) {
            item.take(result.inForce, inForce);
            result.waitingKeys.push_back(item.key);
        }
    }
    return result;
}

}  // namespace

std::vector<Change> changesBetween(const Profile& from, const Profile& to)
{
    std::vector<Change> changes;
    for (const Item& item : items()) {
        if (differs(item, from, to)) {
            changes.push_back({item.key, item.text(from, to), item.text(to, from), item.applies});
        }
    }
    return changes;
}

std::vector<std::string> changedKeys(const Profile& from, const Profile& to)
{
    std::vector<std::string> keys;
    for (const Item& item : items()) {
        if (differs(item, from, to)) {
            keys.push_back(item.key);
        }
    }
    return keys;
}

void takeOver(Profile& into, const Profile& from, std::span<const std::string> keys)
{
    for (const Item& item : items()) {
        if (std::ranges::find(keys, item.key) != keys.end()) {
            item.take(into, from);
        }
    }
}

Application applied(const Profile& inForce, const Profile& wanted)
{
    std::set<std::string> groups;
    const auto waits = [&](const Item& item) {
        return item.applies == Applies::OnReconnect || groups.contains(groupOf(item.key));
    };
    Application result = applyBut(inForce, wanted, waits);
    for (const Problem& problem : crossCheck(result.inForce)) {
        groups.insert(groupOf(problem.key));
    }
    if (groups.empty()) {
        return result;
    }
    result = applyBut(inForce, wanted, waits);
    // Old and new values cannot be combined without a conflict, so all changes wait.
    return crossCheck(result.inForce).empty() ? result : applyBut(inForce, wanted, [](const Item&) { return true; });
}

}  // namespace boresight::profile
