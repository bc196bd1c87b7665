// SPDX-License-Identifier: GPL-3.0-or-later
// The passes that the mount tracks by itself.
#include "core/base/text.h"
#include "core/profile/setting_groups.h"
#include "core/profile/setting_makers.h"

#include <set>

namespace boresight::profile {

using namespace makers;

namespace {

std::vector<SettingOf<schedule::WatchEntry>> makeWatchSettings()
{
    using schedule::WatchEntry;
    return {integer<WatchEntry>(
                "norad", {}, {1.0, 999'999'999.0}, kNow,
                {QT_TRANSLATE_NOOP("Text", "Satellite"),
                 QT_TRANSLATE_NOOP("Text", "Its number in the catalogue of NORAD.")},
                [](auto& row) -> auto& { return row.number; }),
            integer<WatchEntry>(
                "priority", {}, {1.0, 99.0}, kNow,
                {QT_TRANSLATE_NOOP("Text", "Priority"), QT_TRANSLATE_NOOP("Text", "1 is the most important.")},
                [](auto& row) -> auto& { return row.priority; }),
            number<WatchEntry>(
                "min_elevation_deg", "°", {0.0, 89.0}, kNow,
                {QT_TRANSLATE_NOOP("Text", "Lowest elevation"),
                 QT_TRANSLATE_NOOP("Text", "Its passes count from this elevation on.")},
                [](auto& row) -> auto& { return row.leastElevation; })};
}

}  // namespace

void addSchedule(std::vector<Setting>& list)
{
    list.push_back(choice(
        "schedule.policy", {"priority", "longest", "first"}, kNow,
        {QT_TRANSLATE_NOOP("Text", "Passes that overlap"),
         QT_TRANSLATE_NOOP("Text",
                           "Which one is tracked: that of the more important satellite, the longer one, or the "
                           "one that begins first.")},
        [](auto& p) -> auto& { return p.schedule.policy; }));
    list.push_back(number(
        "schedule.lead_s", "s", {60.0, 900.0}, kNow,
        {QT_TRANSLATE_NOOP("Text", "In place before a pass"),
         QT_TRANSLATE_NOOP("Text", "The schedule sends the mount to the beginning of a pass this long before it.")},
        [](auto& p) -> auto& { return p.schedule.lead; }));
    list.push_back(choice(
        "schedule.between", {"hold", "unwind", "park"}, kNow,
        {QT_TRANSLATE_NOOP("Text", "Between passes"),
         QT_TRANSLATE_NOOP("Text", "What the mount does after a pass while the schedule is armed.")},
        [](auto& p) -> auto& { return p.schedule.between; }));
    list.push_back(choice(
        "schedule.park_after", {"off", "on"}, kNow,
        {QT_TRANSLATE_NOOP("Text", "Park after the passes"),
         QT_TRANSLATE_NOOP("Text", "Whether the schedule parks the mount when no pass follows for half an hour.")},
        [](auto& p) -> auto& { return p.schedule.parkAfter; }));
    list.push_back(choice(
        "schedule.unattended", {"off", "on"}, kNow,
        {QT_TRANSLATE_NOOP("Text", "Unattended"),
         QT_TRANSLATE_NOOP("Text",
                           "With \"off\" nothing moves after a start until a person arms the schedule. With "
                           "\"on\" it arms itself once after each start, and the mount moves without anybody.")},
        [](auto& p) -> auto& { return p.schedule.unattended; }));
}

std::span<const SettingOf<schedule::WatchEntry>> watchSettings()
{
    static const std::vector<SettingOf<schedule::WatchEntry>> list = makeWatchSettings();
    return list;
}

void checkSchedule(std::vector<Problem>& problems, const Profile& profile)
{
    std::set<int> seen;
    for (std::size_t i = 0; i < profile.schedule.watch.size(); ++i) {
        const int number = profile.schedule.watch[i].number;
        const std::string key = std::string(kWatchKey) + "[" + std::to_string(i + 1) + "].norad";
        if (number == 0) {
            problems.push_back({key, Text::tr("is needed")});
        } else if (!seen.insert(number).second) {
            problems.push_back({key, Text::tr("is in the list twice")});
        }
    }
}

}  // namespace boresight::profile
