// SPDX-License-Identifier: GPL-3.0-or-later
// Settings of the permitted region, the site, the Sun, the park position and the presets.
#include "core/base/text.h"
#include "core/profile/setting_groups.h"
#include "core/profile/setting_makers.h"

namespace boresight::profile {

using namespace makers;

namespace {

constexpr Range kAxisAngle{-3600.0, 3600.0};
constexpr Range kAzimuth{0.0, 359.999999};  // 360° is written 0
constexpr Range kElevation{-90.0, 90.0};

// Setting one value of the site makes the site known. The reader checks that a file contains all of them.
template <class Access>
Setting siteNumber(const std::string& key, std::string_view unit, Range range, const Words& words, Access access)
{
    Setting setting = number(key, unit, range, Applies::Now, words, access);
    setting.set = [set = setting.set](Profile& profile, const SettingValue& value) {
        return set(profile, value).map([&] { profile.site.known = true; });
    };
    setting.isGiven = [](const Profile& profile) { return profile.site.known; };
    return setting;
}

std::vector<SettingOf<pointing::HorizonPoint>> makeHorizonSettings()
{
    using pointing::HorizonPoint;
    return {
        number<HorizonPoint>(
            "azimuth_deg", "°", kAzimuth, kNow,
            {QT_TRANSLATE_NOOP("Text", "Azimuth"), QT_TRANSLATE_NOOP("Text", "Azimuth of the point, from true north.")},
            [](auto& row) -> auto& { return row.azimuth; }),
        number<HorizonPoint>(
            "elevation_deg", "°", kElevation, kNow,
            {QT_TRANSLATE_NOOP("Text", "Elevation"),
             QT_TRANSLATE_NOOP("Text", "Lowest elevation of the beam at this azimuth.")},
            [](auto& row) -> auto& { return row.elevation; })};
}

std::vector<SettingOf<pointing::KeepOut>> makeKeepOutSettings()
{
    using pointing::KeepOut;
    return {name<KeepOut>(
                "name", kNow, {QT_TRANSLATE_NOOP("Text", "Name"), QT_TRANSLATE_NOOP("Text", "Name of the keep-out.")},
                [](auto& row) -> auto& { return row.name; }),
            number<KeepOut>(
                "azimuth_from_deg", "°", kAzimuth, kNow,
                {QT_TRANSLATE_NOOP("Text", "Azimuth from"),
                 QT_TRANSLATE_NOOP("Text", "Counter-clockwise side of the keep-out.")},
                [](auto& row) -> auto& { return row.azimuthFrom; }),
            number<KeepOut>(
                "azimuth_to_deg", "°", kAzimuth, kNow,
                {QT_TRANSLATE_NOOP("Text", "Azimuth to"),
                 QT_TRANSLATE_NOOP("Text",
                                   "Clockwise side of the keep-out. A keep-out from 350 to 10 passes through north.")},
                [](auto& row) -> auto& { return row.azimuthTo; }),
            number<KeepOut>(
                "elevation_min_deg", "°", kElevation, kNow,
                {QT_TRANSLATE_NOOP("Text", "Elevation from"), QT_TRANSLATE_NOOP("Text", "Lower side of the keep-out.")},
                [](auto& row) -> auto& { return row.elevationMin; }),
            number<KeepOut>(
                "elevation_max_deg", "°", kElevation, kNow,
                {QT_TRANSLATE_NOOP("Text", "Elevation to"), QT_TRANSLATE_NOOP("Text", "Upper side of the keep-out.")},
                [](auto& row) -> auto& { return row.elevationMax; })};
}

std::vector<SettingOf<Preset>> makePresetSettings()
{
    return {name<Preset>(
                "name", kNow, {QT_TRANSLATE_NOOP("Text", "Name"), QT_TRANSLATE_NOOP("Text", "Name of the preset.")},
                [](auto& row) -> auto& { return row.name; }),
            number<Preset>(
                "azimuth_deg", "°", kAzimuth, kNow,
                {QT_TRANSLATE_NOOP("Text", "Azimuth"), QT_TRANSLATE_NOOP("Text", "Azimuth, from true north.")},
                [](auto& row) -> auto& { return row.direction.azimuth; }),
            number<Preset>(
                "elevation_deg", "°", {-90.0, 180.0}, kNow,
                {QT_TRANSLATE_NOOP("Text", "Elevation"),
                 QT_TRANSLATE_NOOP("Text", "Elevation. A value above 90 points over the top.")},
                [](auto& row) -> auto& { return row.direction.elevation; })};
}

}  // namespace

void addRegion(std::vector<Setting>& list)
{
    list.push_back(number(
        "limits.azimuth_min_deg", "°", kAxisAngle, kNow,
        {QT_TRANSLATE_NOOP("Text", "Lowest azimuth"),
         QT_TRANSLATE_NOOP("Text", "Lowest azimuth in operation, as an axis angle. The travel limits the axis, too.")},
        [](auto& p) -> auto& { return p.limits.azimuth.min; }));
    list.push_back(number(
        "limits.azimuth_max_deg", "°", kAxisAngle, kNow,
        {QT_TRANSLATE_NOOP("Text", "Highest azimuth"),
         QT_TRANSLATE_NOOP("Text", "Highest azimuth in operation, as an axis angle.")},
        [](auto& p) -> auto& { return p.limits.azimuth.max; }));
    list.push_back(number(
        "limits.elevation_min_deg", "°", kAxisAngle, kNow,
        {QT_TRANSLATE_NOOP("Text", "Lowest elevation"),
         QT_TRANSLATE_NOOP("Text", "Lowest elevation in operation, as an axis angle.")},
        [](auto& p) -> auto& { return p.limits.elevation.min; }));
    list.push_back(number(
        "limits.elevation_max_deg", "°", kAxisAngle, kNow,
        {QT_TRANSLATE_NOOP("Text", "Highest elevation"),
         QT_TRANSLATE_NOOP("Text", "Highest elevation in operation, as an axis angle.")},
        [](auto& p) -> auto& { return p.limits.elevation.max; }));
}

void addSite(std::vector<Setting>& list)
{
    list.push_back(siteNumber(
        "site.latitude_deg", "°", {-90.0, 90.0},
        {QT_TRANSLATE_NOOP("Text", "Latitude"), QT_TRANSLATE_NOOP("Text", "Latitude of the mount. North is positive.")},
        [](auto& p) -> auto& { return p.site.latitude; }));
    list.push_back(siteNumber(
        "site.longitude_deg", "°", {-180.0, 180.0},
        {QT_TRANSLATE_NOOP("Text", "Longitude"),
         QT_TRANSLATE_NOOP("Text", "Longitude of the mount. East is positive.")},
        [](auto& p) -> auto& { return p.site.longitude; }));
    list.push_back(siteNumber(
        "site.height_m", "m", {-500.0, 9000.0},
        {QT_TRANSLATE_NOOP("Text", "Height"), QT_TRANSLATE_NOOP("Text", "Height of the mount above sea level.")},
        [](auto& p) -> auto& { return p.site.heightMetres; }));
}

void addGpredict(std::vector<Setting>& list)
{
    list.push_back(textual(
        "gpredict.folder", Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "Folder of Gpredict"),
         QT_TRANSLATE_NOOP("Text",
                           "Folder with the stations and satellite data of Gpredict. Empty: the folder that Gpredict "
                           "uses for this user.")},
        [](const Profile& p) { return p.gpredict.folder; },
        [](Profile& p, const std::string& text) -> Result<> {
            if (!text.empty() && text.front() != '/') {
                return failure(ErrorCode::InvalidInput, Text::tr("a path from / on is expected"));
            }
            p.gpredict.folder = text;
            return {};
        }));
}

void addSun(std::vector<Setting>& list)
{
    list.push_back(choice(
        "sun.keep_away", offOn(), Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "Keep away from the Sun"),
         QT_TRANSLATE_NOOP("Text",
                           "Whether the beam stays away from the Sun, whatever moves the mount. This needs the site.")},
        [](auto& p) -> auto& { return p.sun.keepAway; }));
    list.push_back(choice(
        "sun.clock",
        {{"synchronised", QT_TRANSLATE_NOOP("Text", "Only if synchronised")},
         {"trusted", QT_TRANSLATE_NOOP("Text", "Always trusted")}},
        Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "Clock for the Sun"),
         QT_TRANSLATE_NOOP("Text",
                           "With \"synchronised\" Boresight computes the Sun only from a clock that NTP or GPS set in "
                           "the last 24 h. With \"trusted\" it uses the clock of this computer without that check.")},
        [](auto& p) -> auto& { return p.sun.clock; }));
    list.push_back(number(
        "sun.radius_deg", "°", {0.5, 45.0}, Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "Distance from the Sun"),
         QT_TRANSLATE_NOOP("Text", "The beam stays this far from the middle of the Sun.")},
        [](auto& p) -> auto& { return p.sun.radius; }));
}

std::span<const SettingOf<pointing::HorizonPoint>> horizonSettings()
{
    static const std::vector<SettingOf<pointing::HorizonPoint>> list = makeHorizonSettings();
    return list;
}

std::span<const SettingOf<pointing::KeepOut>> keepOutSettings()
{
    static const std::vector<SettingOf<pointing::KeepOut>> list = makeKeepOutSettings();
    return list;
}

std::span<const SettingOf<Preset>> presetSettings()
{
    static const std::vector<SettingOf<Preset>> list = makePresetSettings();
    return list;
}

}  // namespace boresight::profile
