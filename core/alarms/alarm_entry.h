// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "core/units/sky.h"

#include <QString>
#include <QStringList>

#include <array>
#include <string_view>
#include <utility>

// What an alarm has to do with others that stand at the same time. What explains others stands before them.
enum class AlarmKin
{
    Alone,
    BusGone,       // explains what is reported of drives and axes, and every silence
    BusDisturbed,  // explains a silence
    Drive,         // of a drive or its axis: explains the silence of that one
    Silence
};

// One entry of the alarm catalogue: id, severity and sentences of an alarm. A constant of the program. The sentences
// are marked for translation. %1 to %9 in a sentence are the arguments that the alarm is raised with. The id is never
// translated. Any thread.
namespace boresight {

struct AlarmKey;

struct AlarmEntry
{
    static constexpr std::size_t kMostArguments = 4;

    const char* id = "";                    // "drive.silent"
    const char* source = "";                // of its lines in the log. %1 stands for what the alarm is about.
    Severity severity = Severity::Warning;  // the lower one if there are two
    Severity worst = severity;              // the higher one. The place that raises the alarm chooses.
    const char* what = "";                  // what happened
    const char* action = "";                // what Boresight did
    const char* remedy = "";                // what to do
    const char* brief = "";                 // what happened, after the source in the log. Empty: `what`.
    bool thenRearm = false;                 // "Then press Re-arm." follows the remedy
    AlarmHelp help = AlarmHelp::None;       // the button that does what the remedy says
    AlarmKin kin = AlarmKin::Alone;
    std::array<const char*, kMostArguments> examples{};  // one for each argument, for the manual
    // Of the arguments. The others follow what is, a number or a time: the sentence changes, and the alarm stays the
    // same.
    std::size_t identifying = kMostArguments;
    // The id of another entry. Of alarms with one place only the newest stands.
    const char* placeOf = nullptr;

    [[nodiscard]] constexpr std::string_view place() const { return placeOf == nullptr ? id : placeOf; }
    [[nodiscard]] constexpr int argumentCount() const
    {
        int count = 0;
        for (const char* const example : examples) {
            count += example != nullptr ? 1 : 0;
        }
        return count;
    }

    // About one axis, one board of several.
    [[nodiscard]] AlarmKey of(const QString& about) const;
    [[nodiscard]] AlarmKey of(Axis axis) const;
};

// One alarm on the board. Alarms with one place, about the same thing, replace each other.
struct AlarmKey
{
    // Most alarms are about the station, so that their entry is enough.
    AlarmKey(const AlarmEntry& what) : entry(&what) {}
    AlarmKey(const AlarmEntry& what, QString of) : entry(&what), about(std::move(of)) {}

    [[nodiscard]] bool sharesPlace(const AlarmKey& other) const
    {
        return entry->place() == other.entry->place() && about == other.about;
    }

    const AlarmEntry* entry;
    QString about;  // "azimuth"; empty: the station
};

// What an alarm is raised with.
struct AlarmCase
{
    const AlarmEntry& entry;
    QStringList arguments = {};
};

// What the operator reads: what happened, what Boresight did, what to do.
struct AlarmText
{
    QString what;
    QString action;
    QString remedy;
    QString brief;  // of what happened, for the log

    bool operator==(const AlarmText&) const = default;
};

// Whole sentences in the language of the program.
[[nodiscard]] AlarmText textOf(const AlarmEntry& entry, const QStringList& arguments);
// What happened, as a part of another sentence.
[[nodiscard]] QString whatOf(const AlarmCase& alarm);
// Those of the arguments that what happened names and that make it another alarm.
[[nodiscard]] QStringList namedByWhat(const AlarmEntry& entry, const QStringList& arguments);
[[nodiscard]] QString logSource(const AlarmKey& alarm);
// The first of two alarms that both stand is a cause of the second.
[[nodiscard]] bool explains(const AlarmKey& cause, const AlarmKey& result);
// What stands on the button: "Re-arm". Empty: there is none.
[[nodiscard]] QString buttonText(AlarmHelp help);

}  // namespace boresight
