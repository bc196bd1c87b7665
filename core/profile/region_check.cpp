// SPDX-License-Identifier: GPL-3.0-or-later
// Checks settings that depend on each other: region, park position and presets. Also checks the addresses of clients.
#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/pointing/nearest_permitted.h"
#include "core/pointing/permitted_region.h"
#include "core/profile/setting_groups.h"
#include "core/units/degrees_text.h"

#include <QHostAddress>

#include <algorithm>
#include <set>

namespace boresight::profile {

namespace {

std::string rowKey(std::string_view list, std::size_t index)
{
    return std::string(list) + "[" + std::to_string(index + 1) + "]";
}

void checkLimits(std::vector<Problem>& problems, const std::string& axis, const TravelRange& limits,
                 const TravelRange& travel)
{
    const std::string key = "limits." + axis + "_min_deg";
    if (limits.min >= limits.max) {
        problems.push_back({key, Text::tr("%1 is not below limits.%2_max_deg (%3)")
                                     .arg(degreesText(limits.min, 2), toQString(axis), degreesText(limits.max, 2))});
    } else if (travel.min < travel.max && std::max(limits.min, travel.min) >= std::min(limits.max, travel.max)) {
        problems.push_back({key, Text::tr("The limits %1…%2 do not overlap the travel %3…%4.")
                                     .arg(degreesText(limits.min, 2), degreesText(limits.max, 2),
                                          degreesText(travel.min, 2), degreesText(travel.max, 2))});
    }
}

// Checks the limits of operation only. The check of the axis reports a place outside the travel.
bool checkStandLimits(std::vector<Problem>& problems, const std::string& key, const TravelRange& limits, Angle place)
{
    if (limits.contains(place)) {
        return true;
    }
    problems.push_back({key, Text::tr("%1 is outside the limits of operation %2…%3")
                                 .arg(degreesText(place, 2), degreesText(limits.min, 2), degreesText(limits.max, 2))});
    return false;
}

// Checks a place where the mount is parked. Call it only if the region itself has no problem.
void checkStand(std::vector<Problem>& problems, const Profile& profile, const std::string& table,
                const AxisPosition& place)
{
    const TravelRange& azimuthTravel = profile.azimuth.geometry.travel;
    const TravelRange& elevationTravel = profile.elevation.geometry.travel;
    const std::string elevationKey = table + ".elevation_deg";
    const bool isInAzimuth = checkStandLimits(problems, table + ".azimuth_deg", profile.limits.azimuth, place.azimuth);
    const bool isInElevation = checkStandLimits(problems, elevationKey, profile.limits.elevation, place.elevation);
    if (!isInAzimuth || !isInElevation || !azimuthTravel.contains(place.azimuth) ||
        !elevationTravel.contains(place.elevation)) {
        return;
    }
    const pointing::PermittedRegion region(profile.limits, azimuthTravel, elevationTravel,
                                           pointing::PointingModel(profile.pointing));
    if (const QString reason = region.reason(place); !reason.isEmpty()) {
        const auto permitted = pointing::easyPermitted(region, place);
        problems.push_back({elevationKey, reason,
                            permitted
                                ? Text::tr("Permitted: azimuth axis %1, elevation %2.")
                                      .arg(degreesText(permitted->azimuth, 2), degreesText(permitted->elevation, 2))
                                : QString()});
    }
}

void checkCount(std::vector<Problem>& problems, std::string_view key, std::size_t count, std::size_t most,
                const QString& sentence)
{
    if (count > most) {
        problems.push_back({std::string(key), sentence.arg(QString::number(count), QString::number(most))});
    }
}

void checkHorizon(std::vector<Problem>& problems, const std::vector<pointing::HorizonPoint>& horizon)
{
    checkCount(problems, kHorizonKey, horizon.size(), kMaxHorizonPoints,
               Text::tr("%1 points are too many. The maximum is %2."));
    for (std::size_t i = 1; i < horizon.size(); ++i) {
        if (horizon[i].azimuth <= horizon[i - 1].azimuth) {
            problems.push_back({rowKey(kHorizonKey, i),
                                Text::tr("Azimuth %1 does not follow %2. The azimuths must ascend, each once.")
                                    .arg(degreesText(horizon[i].azimuth, 2), degreesText(horizon[i - 1].azimuth, 2))});
        }
    }
}

template <class Row>
void checkNames(std::vector<Problem>& problems, std::string_view list, const std::vector<Row>& rows)
{
    std::set<std::string> names;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (!names.insert(rows[i].name).second) {
            problems.push_back(
                {rowKey(list, i) + ".name", Text::tr("The name \"%1\" is used twice.").arg(toQString(rows[i].name))});
        }
    }
}

void checkKeepOuts(std::vector<Problem>& problems, const std::vector<pointing::KeepOut>& keepOuts)
{
    checkCount(problems, kKeepOutKey, keepOuts.size(), kMaxKeepOuts,
               Text::tr("%1 keep-outs are too many. The maximum is %2."));
    checkNames(problems, kKeepOutKey, keepOuts);
    for (std::size_t i = 0; i < keepOuts.size(); ++i) {
        const pointing::KeepOut& keepOut = keepOuts[i];
        const std::string row = rowKey(kKeepOutKey, i);
        if (keepOut.elevationMin >= keepOut.elevationMax) {
            problems.push_back({row + ".elevation_min_deg",
                                Text::tr("%1 is not below elevation_max_deg (%2)")
                                    .arg(degreesText(keepOut.elevationMin, 2), degreesText(keepOut.elevationMax, 2))});
        }
        if (keepOut.azimuthFrom == keepOut.azimuthTo) {
            problems.push_back(
                {row + ".azimuth_to_deg", Text::tr("is the same as azimuth_from_deg, so the keep-out has no width")});
        }
    }
}

}  // namespace

void checkRegion(std::vector<Problem>& problems, const Profile& profile)
{
    const std::size_t problemsBefore = problems.size();
    checkLimits(problems, "azimuth", profile.limits.azimuth, profile.azimuth.geometry.travel);
    checkLimits(problems, "elevation", profile.limits.elevation, profile.elevation.geometry.travel);
    checkHorizon(problems, profile.limits.horizon);
    checkKeepOuts(problems, profile.limits.keepOuts);
    if (problems.size() == problemsBefore) {
        checkStand(problems, profile, "park", profile.park);
        if (profile.wind.isRead() && profile.wind.stowAt == StowAt::Place) {
            checkStand(problems, profile, "wind", profile.wind.place);
        }
    }
    checkNames(problems, kPresetKey, profile.presets);
    if (profile.sun.keepAway == KeepAway::On && !profile.site.known) {
        problems.push_back(
            {"sun.keep_away",
             Text::tr("The site is not set. Boresight cannot compute the position of the Sun without it.")});
    }
}

Result<> checkAddress(const std::string& text)
{
    const QString address = QString::fromStdString(text);
    const QHostAddress parsed(address);
    // QHostAddress also accepts blanks and short forms like "10.1". They are refused, because their meaning is not
    // clear.
    const bool isLoose = parsed.protocol() == QAbstractSocket::IPv4Protocol && parsed.toString() != address;
    const bool isPlain = std::all_of(text.begin(), text.end(), [](char c) { return c > ' ' && c < '\x7f'; });
    if (parsed.isNull() || isLoose || !isPlain) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("\"%1\" is not an address like 192.168.1.7 or ::1").arg(toQString(text)));
    }
    return {};
}

Result<> checkNetwork(const std::string& text)
{
    const auto slash = text.find('/');
    if (slash == std::string::npos) {
        return checkAddress(text);
    }
    const auto bits = parseInteger(std::string_view(text).substr(slash + 1));
    const QHostAddress address(QString::fromStdString(text.substr(0, slash)));
    const int widest = address.protocol() == QAbstractSocket::IPv4Protocol ? 32 : 128;
    if (!checkAddress(text.substr(0, slash)) || !bits || *bits < 0 || *bits > widest) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("\"%1\" is not a network like 10.0.0.0/8 or fd00::/8").arg(toQString(text)));
    }
    return {};
}

}  // namespace boresight::profile
