// SPDX-License-Identifier: GPL-3.0-or-later
// The passes that the mount tracks by itself, and the recordings of passes.
#include "core/base/control_characters.h"
#include "core/base/text.h"
#include "core/profile/setting_groups.h"
#include "core/profile/setting_makers.h"

namespace boresight::profile {

using namespace makers;

namespace {

std::vector<SettingOf<schedule::WatchEntry>> makeWatchSettings()
{
    using schedule::WatchEntry;
    return {integer<WatchEntry>(
                "norad", {}, {1.0, 999'999'999.0}, kNow,
                {QT_TRANSLATE_NOOP("Text", "Satellite"),
                 QT_TRANSLATE_NOOP("Text", "Number of the satellite in the catalogue of NORAD.")},
                [](auto& row) -> auto& { return row.number; }),
            mayBeLeftOut(integer<WatchEntry>(
                "priority", {}, {1.0, 99.0}, kNow,
                {QT_TRANSLATE_NOOP("Text", "Priority"), QT_TRANSLATE_NOOP("Text", "1 is the most important.")},
                [](auto& row) -> auto& { return row.priority; })),
            mayBeLeftOut(number<WatchEntry>(
                "min_elevation_deg", "°", {0.0, 89.0}, kNow,
                {QT_TRANSLATE_NOOP("Text", "Lowest elevation"),
                 QT_TRANSLATE_NOOP("Text", "Only the part of its passes above this elevation counts.")},
                [](auto& row) -> auto& { return row.leastElevation; }))};
}

constexpr std::size_t kLongestArgument = 1000;

Result<> checkArgument(const std::string& text)
{
    return text.size() > kLongestArgument || hasControlCharacters(text)
               ? failure(ErrorCode::InvalidInput, Text::tr("texts of one line, of at most 1000 bytes, are expected"))
               : Result<>{};
}

// The program is started without a shell and without a search in PATH, so its full path is required.
template <class Access>
Setting command(const std::string& key, const Words& words, Access access)
{
    Setting made = textList(key, kNow, words, access, checkArgument);
    made.set = [set = made.set](Profile& p, const SettingValue& value) -> Result<> {
        const auto* const list = std::get_if<TextList>(&value);
        return list == nullptr || list->empty() || list->front().starts_with('/')
                   ? set(p, value)
                   : failure(ErrorCode::InvalidInput, Text::tr("the path of a program from / on is expected first"));
    };
    return made;
}

void addPassHooks(std::vector<Setting>& list)
{
    list.push_back(command(
        "schedule.hook_before_aos",
        {QT_TRANSLATE_NOOP("Text", "Program before AOS"),
         QT_TRANSLATE_NOOP("Text",
                           "A program with its arguments that runs before a pass of the armed schedule. Its path "
                           "begins with /. There is no shell. Empty: none.")},
        [](auto& p) -> auto& { return p.schedule.hooks.beforeAos; }));
    list.push_back(number(
        "schedule.hook_before_aos_s", "s", {10.0, 900.0}, kNow,
        {QT_TRANSLATE_NOOP("Text", "Time before AOS"),
         QT_TRANSLATE_NOOP(
             "Text",
             "The program before AOS runs this long before AOS. It never runs before LOS of the previous pass.")},
        [](auto& p) -> auto& { return p.schedule.hooks.before; }));
    list.push_back(command(
        "schedule.hook_aos",
        {QT_TRANSLATE_NOOP("Text", "Program at AOS"),
         QT_TRANSLATE_NOOP("Text",
                           "A program that runs when a pass of the armed schedule begins. It has the same form as "
                           "\"Program before AOS\".")},
        [](auto& p) -> auto& { return p.schedule.hooks.aos; }));
    list.push_back(command(
        "schedule.hook_los",
        {QT_TRANSLATE_NOOP("Text", "Program at LOS"),
         QT_TRANSLATE_NOOP("Text",
                           "A program that runs when a pass of the armed schedule ends, also if the pass ends early. "
                           "It has the same form as \"Program before AOS\".")},
        [](auto& p) -> auto& { return p.schedule.hooks.los; }));
    list.push_back(command(
        "schedule.hook_fault",
        {QT_TRANSLATE_NOOP("Text", "Program at a fault"),
         QT_TRANSLATE_NOOP("Text",
                           "A program that runs when a fault ends the armed schedule. It has the same form as "
                           "\"Program before AOS\".")},
        [](auto& p) -> auto& { return p.schedule.hooks.fault; }));
}

}  // namespace

void addSchedule(std::vector<Setting>& list)
{
    list.push_back(choice(
        "schedule.policy",
        {{"priority", QT_TRANSLATE_NOOP("Text", "The more important")},
         {"longest", QT_TRANSLATE_NOOP("Text", "The longer")},
         {"first", QT_TRANSLATE_NOOP("Text", "The earlier")}},
        kNow,
        {QT_TRANSLATE_NOOP("Text", "Passes that overlap"),
         QT_TRANSLATE_NOOP("Text",
                           "Which of two overlapping passes is tracked: the pass of the more important satellite, the "
                           "longer pass, or the pass that begins first.")},
        [](auto& p) -> auto& { return p.schedule.policy; }));
    list.push_back(number(
        "schedule.lead_s", "s", {60.0, 900.0}, kNow,
        {QT_TRANSLATE_NOOP("Text", "In place before a pass"),
         QT_TRANSLATE_NOOP("Text", "The schedule sends the mount to the beginning of a pass this long before it.")},
        [](auto& p) -> auto& { return p.schedule.lead; }));
    list.push_back(choice(
        "schedule.between",
        {{"hold", QT_TRANSLATE_NOOP("Text", "Hold position")},
         {"unwind", QT_TRANSLATE_NOOP("Text", "Unwrap the cable")},
         {"park", QT_TRANSLATE_NOOP("Text", "Park")}},
        kNow,
        {QT_TRANSLATE_NOOP("Text", "Between passes"),
         QT_TRANSLATE_NOOP(
             "Text", "What the mount does after a pass while the schedule is armed. \"unwind\" unwraps the cable.")},
        [](auto& p) -> auto& { return p.schedule.between; }));
    list.push_back(choice(
        "schedule.park_after", offOn(), kNow,
        {QT_TRANSLATE_NOOP("Text", "Park after the passes"),
         QT_TRANSLATE_NOOP("Text", "Whether the schedule parks the mount when no pass follows for half an hour.")},
        [](auto& p) -> auto& { return p.schedule.parkAfter; }));
    list.push_back(choice(
        "schedule.unattended", offOn(), kNow,
        {QT_TRANSLATE_NOOP("Text", "Unattended"),
         QT_TRANSLATE_NOOP("Text",
                           "With \"off\" nothing moves after a start until a person arms the schedule. With \"on\" it "
                           "arms itself once after each start, and the mount moves with nobody present.")},
        [](auto& p) -> auto& { return p.schedule.unattended; }));
    addPassHooks(list);
}

void addRecord(std::vector<Setting>& list)
{
    list.push_back(choice(
        "record.passes", offOn(), kNow,
        {QT_TRANSLATE_NOOP("Text", "Record passes"),
         QT_TRANSLATE_NOOP("Text",
                           "With \"on\" Boresight records each pass in a file: all values of both axes in each control "
                           "tick, the events and the plan. At 50 Hz an hour takes at most 8 MB.")},
        [](auto& p) -> auto& { return p.record.passes; }));
    list.push_back(integer(
        "record.keep_days", "days", {1.0, 3650.0}, kNow,
        {QT_TRANSLATE_NOOP("Text", "Keep for"),
         QT_TRANSLATE_NOOP(
             "Text",
             "Older recordings are deleted when the next recording begins, while a time source sets the clock.")},
        [](auto& p) -> auto& { return p.record.keepDays; }));
    list.push_back(integer(
        "record.keep_megabytes", "MB", {10.0, 1'000'000.0}, kNow,
        {QT_TRANSLATE_NOOP("Text", "Keep at most"),
         QT_TRANSLATE_NOOP(
             "Text",
             "When a recording begins, and when the disk is full, the oldest recordings of this mount are deleted "
             "while all together are larger.")},
        [](auto& p) -> auto& { return p.record.keepMegabytes; }));
}

std::span<const SettingOf<schedule::WatchEntry>> watchSettings()
{
    static const std::vector<SettingOf<schedule::WatchEntry>> list = makeWatchSettings();
    return list;
}

void checkSchedule(std::vector<Problem>& problems, const Profile& profile)
{
    checkNumbers(problems, kWatchKey, profile.schedule.watch);
}

}  // namespace boresight::profile
