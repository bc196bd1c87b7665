// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "core/units/sky.h"

#include <QString>
#include <QStringList>

#include <array>
#include <string_view>
#include <utility>

// How an alarm relates to others that are active at the same time. A cause is listed before the alarms that it
// explains.
enum class AlarmKin
{
    Alone,
    BusGone,       // explains reports of drives and axes, and every silence
    BusDisturbed,  // explains a silence
    Drive,         // of a drive or its axis: explains the silence of the same drive
    Silence
};

// One entry of the alarm catalogue: id, severity and sentences of an alarm. A constant of the program. The sentences
// are marked for translation. %1 to %9 in a sentence are the arguments of the alarm. The id is never translated. Any
// thread.
namespace boresight {

struct AlarmKey;

struct AlarmEntry
{
    static constexpr std::size_t kMostArguments = 4;

    const char* id = "";                    // "drive.silent"
    const char* source = "";                // of its lines in the log. %1 is the subject of the alarm
    Severity severity = Severity::Warning;  // the lower one if there are two
    Severity worst = severity;              // the higher one. The place that raises the alarm chooses.
    const char* what = "";                  // what happened
    const char* action = "";                // what Boresight did
    const char* remedy = "";                // what to do
    const char* brief = "";                 // what happened, after the source in the log. Empty: `what`
    bool thenRearm = false;                 // "Then press Re-arm." follows the remedy
    AlarmHelp help = AlarmHelp::None;       // the button that carries out the remedy
    AlarmKin kin = AlarmKin::Alone;
    std::array<const char*, kMostArguments> examples{};  // one for each argument, for the manual
    // The number of arguments that identify the alarm. The other arguments are changing numbers or times: they change
    // the sentence, but the alarm stays the same.
    std::size_t identifying = kMostArguments;
    // The id of another entry. Alarms with the same place replace each other.
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

    // The alarm about one axis or one of several boards.
    [[nodiscard]] AlarmKey of(const QString& about) const;
    [[nodiscard]] AlarmKey of(Axis axis) const;
};

// One alarm on the board. Alarms with the same place and the same subject replace each other.
struct AlarmKey
{
    // Most alarms are about the station, so the entry alone is enough.
    AlarmKey(const AlarmEntry& what) : entry(&what) {}
    AlarmKey(const AlarmEntry& what, QString of) : entry(&what), about(std::move(of)) {}

    [[nodiscard]] bool sharesPlace(const AlarmKey& other) const
    {
        return entry->place() == other.entry->place() && about == other.about;
    }

    const AlarmEntry* entry;
    QString about;  // "azimuth"; empty: the station
};

// An entry with the arguments of an alarm.
struct AlarmCase
{
    const AlarmEntry& entry;
    QStringList arguments = {};
};

// The text for the operator: what happened, what Boresight did, what to do.
struct AlarmText
{
    QString what;
    QString action;
    QString remedy;
    QString brief;  // what happened, for the log

    bool operator==(const AlarmText&) const = default;
};

// Whole sentences in the language of the program.
[[nodiscard]] AlarmText textOf(const AlarmEntry& entry, const QStringList& arguments);
// What happened, as part of another sentence.
[[nodiscard]] QString whatOf(const AlarmCase& alarm);
// The identifying arguments that occur in the sentence about what happened.
[[nodiscard]] QStringList namedByWhat(const AlarmEntry& entry, const QStringList& arguments);
[[nodiscard]] QString logSource(const AlarmKey& alarm);
// True: of two active alarms, the first is a cause of the second.
[[nodiscard]] bool explains(const AlarmKey& cause, const AlarmKey& result);
// The text on the button: "Re-arm". Empty: there is no button.
[[nodiscard]] QString buttonText(AlarmHelp help);

}  // namespace boresight
