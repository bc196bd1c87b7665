// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/profile/wind_settings.h"

#include "core/base/control_characters.h"
#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/profile/setting_groups.h"
#include "core/profile/setting_makers.h"
#include "core/units/degrees_text.h"
#include "core/wind/wind_source.h"

namespace boresight::profile {

using namespace makers;

namespace {

constexpr std::size_t kLongestKey = 100;
constexpr Range kWindSpeed{0.5, 100.0};  // m/s

Result<> checkKey(const std::string& key)
{
    const bool isKey =
        !key.empty() && key.size() <= kLongestKey && !hasControlCharacters(key) && key.find(' ') == std::string::npos;
    return isKey ? Result<>{}
                 : failure(ErrorCode::InvalidInput,
                           Text::tr("a word of at most %1 characters is expected").arg(kLongestKey));
}

// How a reading arrives, and how Boresight reads the wind speed from it.
void addReading(std::vector<Setting>& list)
{
    list.push_back(textual(
        "wind.source", kNow,
        {QT_TRANSLATE_NOOP("Text", "Source"),
         QT_TRANSLATE_NOOP("Text",
                           "Where the readings of an anemometer arrive: udp:PORT on this computer, udp:0.0.0.0:PORT "
                           "from all computers, mqtt:TOPIC of the MQTT broker, or the page of a web server, such as "
                           "http://anemometer/wind. Empty: none, and the wind parks nothing.")},
        [](const Profile& p) { return p.wind.source; },
        [](Profile& p, const std::string& text) {
            return wind::parseSource(text).map([&](const wind::SourceName&) { p.wind.source = text; });
        }));
    list.push_back(number(
        "wind.poll_s", "s", {1.0, 600.0}, kNow,
        {QT_TRANSLATE_NOOP("Text", "Interval"),
         QT_TRANSLATE_NOOP("Text", "How often the page of a web server is read.")},
        [](auto& p) -> auto& { return p.wind.poll; }));
    list.push_back(textual(
        "wind.key", kNow,
        {QT_TRANSLATE_NOOP("Text", "Key"),
         QT_TRANSLATE_NOOP("Text",
                           "The name of the wind speed in a JSON message, for example wind_gust, or wind.speed for an "
                           "object in an object. A plain number needs no key.")},
        [](const Profile& p) { return p.wind.format.key; },
        [](Profile& p, const std::string& text) { return checkKey(text).map([&] { p.wind.format.key = text; }); }));
    list.push_back(choice(
        "wind.unit",
        {{"m/s", QT_TRANSLATE_NOOP("Text", "m/s")},
         {"km/h", QT_TRANSLATE_NOOP("Text", "km/h")},
         {"knots", QT_TRANSLATE_NOOP("Text", "Knots")}},
        kNow,
        {QT_TRANSLATE_NOOP("Text", "Unit"),
         QT_TRANSLATE_NOOP("Text", "The unit in which the anemometer reports. The limits below are always in m/s.")},
        [](auto& p) -> auto& { return p.wind.format.unit; }));
}

void addWindLimits(std::vector<Setting>& list)
{
    list.push_back(number(
        "wind.stow_above_m_s", "m/s", kWindSpeed, kNow,
        {QT_TRANSLATE_NOOP("Text", "Park above"),
         QT_TRANSLATE_NOOP("Text",
                           "Above this wind the mount parks, and every other motion is refused. 15 m/s are 54 km/h or "
                           "29 knots.")},
        [](auto& p) -> auto& { return p.wind.stowAbove; }));
    list.push_back(number(
        "wind.release_below_m_s", "m/s", kWindSpeed, kNow,
        {QT_TRANSLATE_NOOP("Text", "Permit motion below"),
         QT_TRANSLATE_NOOP("Text", "The mount may move again after the wind was below this limit for the time below.")},
        [](auto& p) -> auto& { return p.wind.releaseBelow; }));
    list.push_back(number(
        "wind.calm_min", "min", {0.0, 240.0}, kNow,
        {QT_TRANSLATE_NOOP("Text", "Calm time"),
         QT_TRANSLATE_NOOP("Text",
                           "The wind must stay below the lower limit for this time. Then the mount may move, but "
                           "nothing moves by itself.")},
        [](auto& p) -> auto& { return p.wind.calm; }));
    list.push_back(number(
        "wind.gust_s", "s", {0.0, 60.0}, kNow,
        {QT_TRANSLATE_NOOP("Text", "Mean of a gust"),
         QT_TRANSLATE_NOOP("Text",
                           "Boresight uses the mean of the readings of this time. Weather services define a gust by 3 "
                           "s. 0: Boresight uses each reading.")},
        [](auto& p) -> auto& { return p.wind.gust; }));
    list.push_back(number(
        "wind.silence_s", "s", {2.0, 3600.0}, kNow,
        {QT_TRANSLATE_NOOP("Text", "Longest silence"),
         QT_TRANSLATE_NOOP("Text", "Without a reading for this long the wind is unknown.")},
        [](auto& p) -> auto& { return p.wind.silence; }));
    list.push_back(choice(
        "wind.when_silent",
        {{"tell", QT_TRANSLATE_NOOP("Text", "Raise an alarm")}, {"stow", QT_TRANSLATE_NOOP("Text", "Park the mount")}},
        kNow,
        {QT_TRANSLATE_NOOP("Text", "If the wind is unknown"),
         QT_TRANSLATE_NOOP("Text", "\"tell\" raises an alarm. \"stow\" parks the mount as in a strong wind.")},
        [](auto& p) -> auto& { return p.wind.whenSilent; }));
}

void addStow(std::vector<Setting>& list)
{
    list.push_back(choice(
        "wind.stow_at",
        {{"park", QT_TRANSLATE_NOOP("Text", "Park position")}, {"place", QT_TRANSLATE_NOOP("Text", "The place below")}},
        kNow,
        {QT_TRANSLATE_NOOP("Text", "Place in a strong wind"),
         QT_TRANSLATE_NOOP("Text",
                           "Where the mount parks in a strong wind: at its park position, or at the place below.")},
        [](auto& p) -> auto& { return p.wind.stowAt; }));
    list.push_back(number(
        "wind.azimuth_deg", "°", {-3600.0, 3600.0}, kNow,
        {QT_TRANSLATE_NOOP("Text", "Azimuth of this place"),
         QT_TRANSLATE_NOOP("Text", "Azimuth of the place in a strong wind, as an axis angle.")},
        [](auto& p) -> auto& { return p.wind.place.azimuth; }));
    list.push_back(number(
        "wind.elevation_deg", "°", {-3600.0, 3600.0}, kNow,
        {QT_TRANSLATE_NOOP("Text", "Elevation of this place"),
         QT_TRANSLATE_NOOP("Text", "Elevation of the place in a strong wind, as an axis angle.")},
        [](auto& p) -> auto& { return p.wind.place.elevation; }));
    list.push_back(number(
        "wind.override_min", "min", {1.0, 240.0}, kNow,
        {QT_TRANSLATE_NOOP("Text", "Move anyway"),
         QT_TRANSLATE_NOOP("Text",
                           "How long the operator may move the mount in a strong wind after Move anyway. Then it "
                           "parks again.")},
        [](auto& p) -> auto& { return p.wind.overrideFor; }));
}

void checkWindTopic(std::vector<Problem>& problems, const Profile& profile)
{
    const auto source = wind::parseSource(profile.wind.source);
    if (!source || source->kind != wind::SourceKind::Mqtt) {
        return;
    }
    const std::string topic = source->place.toStdString();
    if (profile.sensor.reads(topic) || profile.position.reads(topic)) {
        problems.push_back({"wind.source", Text::tr("the sensor or the positions already use this topic")});
    }
}

// Checks the travel only. checkRegion() reports a place outside the limits of operation.
void checkWindTravel(std::vector<Problem>& problems, const std::string& axis, const TravelRange& travel, Angle place)
{
    if (travel.min < travel.max && !travel.contains(place)) {
        problems.push_back({"wind." + axis + "_deg",
                            Text::tr("%1 is outside the travel %2…%3")
                                .arg(degreesText(place, 2), degreesText(travel.min, 2), degreesText(travel.max, 2))});
    }
}

}  // namespace

void addWind(std::vector<Setting>& list)
{
    addReading(list);
    addWindLimits(list);
    addStow(list);
}

void checkWind(std::vector<Problem>& problems, const Profile& profile)
{
    if (profile.wind.releaseBelow > profile.wind.stowAbove) {
        problems.push_back({"wind.release_below_m_s", Text::tr("%1 is above wind.stow_above_m_s (%2)")
                                                          .arg(toQString(formatFixed(profile.wind.releaseBelow, 1)),
                                                               toQString(formatFixed(profile.wind.stowAbove, 1)))});
    }
    checkWindTopic(problems, profile);
    if (profile.wind.isRead() && profile.wind.stowAt == StowAt::Place) {
        checkWindTravel(problems, "azimuth", profile.azimuth.geometry.travel, profile.wind.place.azimuth);
        checkWindTravel(problems, "elevation", profile.elevation.geometry.travel, profile.wind.place.elevation);
    }
}

}  // namespace boresight::profile
