// SPDX-License-Identifier: GPL-3.0-or-later
// The satellites that are known, and the Moon of azel.dat.
#include "core/base/control_characters.h"
#include "core/base/text.h"
#include "core/elements/element_address.h"
#include "core/profile/setting_groups.h"
#include "core/profile/setting_makers.h"

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

// Of one line: the file and the window have no place for more.
Result<> checkNote(const std::string& note)
{
    return hasControlCharacters(note) || toQString(note).size() > static_cast<qsizetype>(orbit::kLongestNote)
               ? failure(ErrorCode::InvalidInput,
                         Text::tr("a text of one line, of at most %1 characters, is expected").arg(orbit::kLongestNote))
               : Result<>{};
}

std::vector<SettingOf<orbit::SatelliteMark>> makeSatelliteSettings()
{
    using orbit::SatelliteMark;
    return {
        integer<SatelliteMark>(
            "norad", {}, {1.0, 999'999'999.0}, kNow,
            {QT_TRANSLATE_NOOP("Text", "Satellite"),
             QT_TRANSLATE_NOOP("Text", "Its number in the catalogue of NORAD.")},
            [](auto& row) -> auto& { return row.number; }),
        choice<SatelliteMark>(
            "favourite", {"off", "on"}, kNow,
            {QT_TRANSLATE_NOOP("Text", "Favourite"),
             QT_TRANSLATE_NOOP("Text",
                               "Whether the satellite is a favourite, with a star and a place in the timeline.")},
            [](auto& row) -> auto& { return row.favourite; }),
        textual<SatelliteMark>(
            "note", kNow,
            {QT_TRANSLATE_NOOP("Text", "Note"),
             QT_TRANSLATE_NOOP("Text", "A line of the operator's own, such as frequency and polarisation.")},
            [](const SatelliteMark& row) { return row.note; },
            [](SatelliteMark& row, const std::string& note) { return checkNote(note).map([&] { row.note = note; }); })};
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
         QT_TRANSLATE_NOOP("Text",
                           "Satellites with older elements are not tracked. The error of a low orbit grows by some "
                           "kilometres a day.")},
        [](auto& p) -> auto& { return p.orbit.oldestDays; }));
    list.push_back(number(
        "orbit.lead_s", "s", {-1.0, 1.0}, kNow,
        {QT_TRANSLATE_NOOP("Text", "Lead of the set-points"),
         QT_TRANSLATE_NOOP("Text", "The mount aims at where the tracked satellite is this much later.")},
        [](auto& p) -> auto& { return p.orbit.lead; }));
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
         QT_TRANSLATE_NOOP("Text", "The mount moves on to the Moon at most this often. At 1 s it moves all the time.")},
        [](auto& p) -> auto& { return p.azel.interval; }));
    list.push_back(number(
        "azel.beam_fraction", "", {0.0, 1.0}, kNow,
        {QT_TRANSLATE_NOOP("Text", "Part of the beam width"),
         QT_TRANSLATE_NOOP("Text",
                           "The mount moves on only when the Moon is this part of the beam width away from where the "
                           "mount points. 0: the interval alone counts.")},
        [](auto& p) -> auto& { return p.azel.beamFraction; }));
    list.push_back(choice(
        "azel.only_while_receiving", {"off", "on"}, kNow,
        {QT_TRANSLATE_NOOP("Text", "Move only while receiving"),
         QT_TRANSLATE_NOOP(
             "Text",
             "Whether the mount stands still while WSJT-X transmits. It catches up in the next receive period.")},
        [](auto& p) -> auto& { return p.azel.onlyWhileReceiving; }));
}

std::span<const SettingOf<orbit::SatelliteMark>> satelliteSettings()
{
    static const std::vector<SettingOf<orbit::SatelliteMark>> list = makeSatelliteSettings();
    return list;
}

void checkSatellites(std::vector<Problem>& problems, const Profile& profile)
{
    checkNumbers(problems, kSatelliteKey, profile.satellites);
}

}  // namespace boresight::profile
