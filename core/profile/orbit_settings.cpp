// SPDX-License-Identifier: GPL-3.0-or-later
// Settings of satellites and refraction, of the lock to the target of a client, of the Moon from azel.dat, and of the
// position of a balloon or rocket.
#include "core/base/control_characters.h"
#include "core/base/text.h"
#include "core/elements/element_address.h"
#include "core/profile/setting_groups.h"
#include "core/profile/setting_makers.h"

#include <algorithm>
#include <string>

namespace boresight::profile {

using namespace makers;

namespace {

Result<> checkPath(const std::string& path)
{
    return path.starts_with('/') ? Result<>{}
                                 : failure(ErrorCode::InvalidInput, Text::tr("a path from / on is expected"));
}

Result<> checkElements(const std::string& entry)
{
    if (orbit::isElementAddress(entry)) {
        return orbit::parseElementAddress(entry).map([](const orbit::ElementAddress&) {});
    }
    return entry.starts_with('/')
               ? Result<>{}
               : failure(ErrorCode::InvalidInput, Text::tr("a path from / on, an address that begins with https://, or "
                                                           "celestrak:GROUP is expected"));
}

// A note is one line, because the file and the window have room for one line only.
Result<> checkNote(const std::string& note)
{
    return hasControlCharacters(note) || toQString(note).size() > static_cast<qsizetype>(orbit::kLongestNote)
               ? failure(ErrorCode::InvalidInput,
                         Text::tr("a text of one line, of at most %1 characters, is expected").arg(orbit::kLongestNote))
               : Result<>{};
}

// Refuses the wildcards of MQTT: only one topic is read.
Result<> checkPositionTopic(const std::string& topic)
{
    const bool isTopic = !topic.empty() && topic.front() != '$' && topic.find_first_of("+#") == std::string::npos;
    return isTopic ? checkNote(topic)
                   : failure(ErrorCode::InvalidInput, Text::tr("a topic is expected, without + # and $"));
}

std::vector<SettingOf<orbit::SatelliteMark>> makeSatelliteSettings()
{
    using orbit::SatelliteMark;
    return {
        integer<SatelliteMark>(
            "norad", {}, {1.0, 999'999'999.0}, kNow,
            {QT_TRANSLATE_NOOP("Text", "Satellite"),
             QT_TRANSLATE_NOOP("Text", "Number of the satellite in the catalogue of NORAD.")},
            [](auto& row) -> auto& { return row.number; }),
        mayBeLeftOut(choice<SatelliteMark>(
            "favourite", offOn(), kNow,
            {QT_TRANSLATE_NOOP("Text", "Favourite"),
             QT_TRANSLATE_NOOP("Text",
                               "Whether the satellite is a favourite, with a star and a place in the timeline.")},
            [](auto& row) -> auto& { return row.favourite; })),
        mayBeLeftOut(textual<SatelliteMark>(
            "note", kNow,
            {QT_TRANSLATE_NOOP("Text", "Note"),
             QT_TRANSLATE_NOOP("Text", "A note of one line, such as frequency and polarisation.")},
            [](const SatelliteMark& row) { return row.note; },
            [](SatelliteMark& row, const std::string& note) { return checkNote(note).map([&] { row.note = note; }); })),
        mayBeLeftOut(textual<SatelliteMark>(
            "antenna", kNow,
            {QT_TRANSLATE_NOOP("Text", "Antenna"),
             QT_TRANSLATE_NOOP(
                 "Text",
                 "Name of the antenna that tracks the satellite. \"main\" is the antenna of the table mount. "
                 "Without this key Boresight uses the antenna chosen by hand.")},
            [](const SatelliteMark& row) { return row.antenna; },
            [](SatelliteMark& row, const std::string& text) {
                return (text.empty() ? Result<>{} : checkName(text)).map([&] { row.antenna = text; });
            }))};
}

}  // namespace

void addOrbit(std::vector<Setting>& list)
{
    list.push_back(textList(
        "orbit.elements", kNow,
        {QT_TRANSLATE_NOOP("Text", "Element files"),
         QT_TRANSLATE_NOOP(
             "Text",
             "Files, folders and https addresses with the orbital elements of satellites: TLE, or OMM as "
             "JSON, CSV, XML or KVN. celestrak:stations is a group of CelesTrak. Empty: the satellites of "
             "Gpredict on this computer.")},
        [](auto& p) -> auto& { return p.orbit.elements; }, checkElements));
    list.push_back(number(
        "orbit.oldest_days", "d", {1.0, 3650.0}, kNow,
        {QT_TRANSLATE_NOOP("Text", "Oldest elements"),
         QT_TRANSLATE_NOOP(
             "Text",
             "Satellites with older elements are not tracked. The error of a low orbit grows by 1 to 3 km a day.")},
        [](auto& p) -> auto& { return p.orbit.oldestDays; }));
    list.push_back(number(
        "orbit.lead_s", "s", {-1.0, 1.0}, kNow,
        {QT_TRANSLATE_NOOP("Text", "Lead of the set-points"),
         QT_TRANSLATE_NOOP("Text", "The mount aims at the place where the tracked satellite will be after this time.")},
        [](auto& p) -> auto& { return p.orbit.lead; }));
    list.push_back(choice(
        "orbit.refraction",
        {{"by_kind", QT_TRANSLATE_NOOP("Text", "By kind of target")},
         {"none", QT_TRANSLATE_NOOP("Text", "Off")},
         {"light", QT_TRANSLATE_NOOP("Text", "Optical")},
         {"radio", QT_TRANSLATE_NOOP("Text", "Radio")}},
        kNow,
        {QT_TRANSLATE_NOOP("Text", "Refraction"),
         QT_TRANSLATE_NOOP("Text",
                           "Which refraction of the air Boresight applies. By kind: Sun, Moon and planets like light, "
                           "radio sources like radio waves, satellites not at all. The other values hold for all "
                           "targets. AOS and LOS of satellites stay geometric.")},
        [](auto& p) -> auto& { return p.orbit.refraction; }));
}

void addClientLock(std::vector<Setting>& list)
{
    list.push_back(choice(
        "clients.lock",
        {{"always", QT_TRANSLATE_NOOP("Text", "Always")},
         {"ask", QT_TRANSLATE_NOOP("Text", "Ask")},
         {"never", QT_TRANSLATE_NOOP("Text", "Never")}},
        kNow,
        {QT_TRANSLATE_NOOP("Text", "Lock to the target of a client"),
         QT_TRANSLATE_NOOP("Text",
                           "What Boresight does when it recognises the target that a client tracks, such as a "
                           "satellite of Gpredict. \"always\": it tracks the target from its own orbit as soon as "
                           "the points of the client move along the target. \"ask\": the window offers this. "
                           "\"never\": only the points of the client move the mount. While "
                           "rotctld.outside_limits is \"refuse\", \"always\" and \"ask\" do the same as "
                           "\"never\".")},
        [](auto& p) -> auto& { return p.clientLock; }));
}

void addAzel(std::vector<Setting>& list)
{
    list.push_back(textual(
        "azel.file", kNow,
        {QT_TRANSLATE_NOOP("Text", "azel.dat"),
         QT_TRANSLATE_NOOP("Text",
                           "The file by which WSJT-X, MAP65 or QMAP report the Moon. Empty: azel.dat in the folder of "
                           "WSJT-X of this user.")},
        [](const Profile& p) { return p.azel.file; },
        [](Profile& p, const std::string& text) -> Result<> {
            return (text.empty() ? Result<>{} : checkPath(text)).map([&] { p.azel.file = text; });
        }));
    list.push_back(number(
        "azel.interval_s", "s", {1.0, 3600.0}, kNow,
        {QT_TRANSLATE_NOOP("Text", "Interval"),
         QT_TRANSLATE_NOOP("Text",
                           "The mount moves to the new direction of the Moon at most once in this time. At 1 s it "
                           "moves all the time.")},
        [](auto& p) -> auto& { return p.azel.interval; }));
    list.push_back(number(
        "azel.beam_fraction", "", {0.0, 1.0}, kNow,
        {QT_TRANSLATE_NOOP("Text", "Part of the beam width"),
         QT_TRANSLATE_NOOP("Text",
                           "The mount moves only when its distance from the Moon is this part of the beam width. 0: "
                           "only the interval counts.")},
        [](auto& p) -> auto& { return p.azel.beamFraction; }));
    list.push_back(choice(
        "azel.only_while_receiving", offOn(), kNow,
        {QT_TRANSLATE_NOOP("Text", "Move only while receiving"),
         QT_TRANSLATE_NOOP(
             "Text",
             "Whether the mount stands still while WSJT-X transmits. It catches up in the next receive period.")},
        [](auto& p) -> auto& { return p.azel.onlyWhileReceiving; }));
}

void addPosition(std::vector<Setting>& list)
{
    list.push_back(choice(
        "position.source",
        {{"none", QT_TRANSLATE_NOOP("Text", "None")},
         {"udp", QT_TRANSLATE_NOOP("Text", "UDP")},
         {"mqtt", QT_TRANSLATE_NOOP("Text", "MQTT broker")}},
        kNow,
        {QT_TRANSLATE_NOOP("Text", "Source"),
         QT_TRANSLATE_NOOP("Text",
                           "How Boresight receives the position of a balloon or a rocket to track: by UDP on a port of "
                           "this computer, or by a topic of the MQTT broker.")},
        [](auto& p) -> auto& { return p.position.source; }));
    list.push_back(textual(
        "position.host", kNow,
        {QT_TRANSLATE_NOOP("Text", "Host"),
         QT_TRANSLATE_NOOP(
             "Text",
             "UDP: the address of this computer to listen on. 127.0.0.1 receives from this computer only, "
             "0.0.0.0 receives from all computers, broadcasts included.")},
        [](const Profile& p) { return p.position.host; },
        [](Profile& p, const std::string& text) { return checkHost(text).map([&] { p.position.host = text; }); }));
    list.push_back(integer(
        "position.port", "", {1, 65535}, kNow,
        {QT_TRANSLATE_NOOP("Text", "Port"),
         QT_TRANSLATE_NOOP("Text", "UDP port of the positions. radiosonde_auto_rx sends to 55673.")},
        [](auto& p) -> auto& { return p.position.port; }));
    list.push_back(textual(
        "position.topic", kNow,
        {QT_TRANSLATE_NOOP("Text", "Topic"), QT_TRANSLATE_NOOP("Text", "MQTT: the topic of the positions.")},
        [](const Profile& p) { return p.position.topic; },
        [](Profile& p, const std::string& text) {
            return checkPositionTopic(text).map([&] { p.position.topic = text; });
        }));
    list.push_back(textual(
        "position.name", kNow,
        {QT_TRANSLATE_NOOP("Text", "Call sign"),
         QT_TRANSLATE_NOOP("Text",
                           "Only reports with this call sign count. Empty: every report counts. Then only one balloon "
                           "or rocket may fly.")},
        [](const Profile& p) { return p.position.name; },
        [](Profile& p, const std::string& text) { return checkNote(text).map([&] { p.position.name = text; }); }));
    list.push_back(number(
        "position.stale_s", "s", {2.0, 600.0}, kNow,
        {QT_TRANSLATE_NOOP("Text", "Longest silence"),
         QT_TRANSLATE_NOOP("Text", "Without a position for this long the mount stands still.")},
        [](auto& p) -> auto& { return p.position.stale; }));
    list.push_back(number(
        "position.fastest_m_s", "m/s", {10.0, 12000.0}, kNow,
        {QT_TRANSLATE_NOOP("Text", "Fastest flight"),
         QT_TRANSLATE_NOOP(
             "Text", "A position is refused if the balloon or rocket would have to fly faster than this to reach it.")},
        [](auto& p) -> auto& { return p.position.fastest; }));
}

void checkPosition(std::vector<Problem>& problems, const Profile& profile)
{
    if (profile.position.source == PositionSource::Udp && !checkAddress(profile.position.host)) {
        problems.push_back(
            {"position.host", Text::tr("an address of this computer is expected while position.source is \"udp\"")});
    }
    if (profile.position.source == PositionSource::Mqtt && profile.sensor.reads(profile.position.topic)) {
        problems.push_back({"position.topic", Text::tr("is the same as a topic of the sensor")});
    }
}

std::span<const SettingOf<orbit::SatelliteMark>> satelliteSettings()
{
    static const std::vector<SettingOf<orbit::SatelliteMark>> list = makeSatelliteSettings();
    return list;
}

void checkSatellites(std::vector<Problem>& problems, const Profile& profile)
{
    checkNumbers(problems, kSatelliteKey, profile.satellites);
    QStringList names;
    for (const pointing::Antenna& antenna : profile.allAntennas()) {
        names << QStringLiteral("\"%1\"").arg(toQString(antenna.name));
    }
    names.removeDuplicates();
    for (std::size_t i = 0; i < profile.satellites.size(); ++i) {
        const std::string& antenna = profile.satellites[i].antenna;
        if (!antenna.empty() && profile.antenna(antenna).name != antenna) {
            problems.push_back(
                {std::string(kSatelliteKey) + "[" + std::to_string(i + 1) + "].antenna",
                 Text::tr("There is no antenna \"%1\". Name one of %2, or add [[antenna]] with this name.")
                     .arg(toQString(antenna), names.join(QStringLiteral(", ")))});
        }
    }
}

}  // namespace boresight::profile
