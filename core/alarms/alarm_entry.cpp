// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/alarms/alarm_entry.h"

#include "core/base/text.h"

#include <algorithm>

namespace boresight {
namespace {

bool endsSentence(const QString& text)
{
    return text.endsWith(QLatin1Char('.')) || text.endsWith(QLatin1Char('?')) || text.endsWith(QLatin1Char('!'));
}

// The parts come from different sources: some are whole sentences, some are not. A device name keeps its first letter.
QString asSentence(const QString& text)
{
    if (text.isEmpty()) {
        return text;
    }
    const QString sentence = endsSentence(text) ? text : text + QLatin1Char('.');
    const auto word = std::ranges::find_if_not(sentence, [](QChar letter) { return letter.isLetter(); });
    const bool plain = word != sentence.end() && *word == QLatin1Char(' ');
    return plain ? sentence[0].toUpper() + sentence.sliced(1) : sentence;
}

// The index of the argument at this position of the sentence, for example 1 for "%2". -1: no argument.
qsizetype argumentAt(const QString& sentence, qsizetype place)
{
    const bool named = sentence[place] == QLatin1Char('%') && place + 1 < sentence.size();
    const int digit = named ? sentence[place + 1].digitValue() : -1;
    return digit > 0 ? digit - 1 : -1;
}

// Not QString::arg(), because it would start with the lowest number in the sentence.
QString filled(const char* marked, const QStringList& arguments)
{
    const QString sentence = Text::of(marked);
    QString text;
    for (qsizetype i = 0; i < sentence.size(); ++i) {
        const qsizetype argument = argumentAt(sentence, i);
        if (argument < 0) {
            text += sentence[i];
        } else {
            text += arguments.value(argument);
            ++i;
        }
    }
    return text;
}

}  // namespace

AlarmKey AlarmEntry::of(const QString& about) const
{
    return {*this, about};
}

AlarmKey AlarmEntry::of(Axis axis) const
{
    return of(axis == Axis::Azimuth ? QStringLiteral("azimuth") : QStringLiteral("elevation"));
}

AlarmText textOf(const AlarmEntry& entry, const QStringList& arguments)
{
    const QString remedy = filled(entry.remedy, arguments);
    return {.what = asSentence(filled(entry.what, arguments)),
            .action = asSentence(filled(entry.action, arguments)),
            .remedy = asSentence(entry.thenRearm ? Text::tr("%1 Then press Re-arm").arg(remedy) : remedy),
            .brief = asSentence(filled(*entry.brief == '\0' ? entry.what : entry.brief, arguments))};
}

QString whatOf(const AlarmCase& alarm)
{
    return filled(alarm.entry.what, alarm.arguments);
}

QStringList namedByWhat(const AlarmEntry& entry, const QStringList& arguments)
{
    const QString sentence = QString::fromUtf8(entry.what);
    QStringList named;
    for (qsizetype i = 0; i < sentence.size(); ++i) {
        const qsizetype argument = argumentAt(sentence, i);
        if (argument >= 0 && static_cast<std::size_t>(argument) < entry.identifying) {
            named << arguments.value(argument);
        }
    }
    return named;
}

QString logSource(const AlarmKey& alarm)
{
    return QString::fromUtf8(alarm.entry->source).replace(QLatin1String("%1"), alarm.about);
}

bool explains(const AlarmKey& cause, const AlarmKey& result)
{
    const bool silence = result.entry->kin == AlarmKin::Silence;
    switch (cause.entry->kin) {
        case AlarmKin::BusGone:
            return silence || result.entry->kin == AlarmKin::Drive;
        case AlarmKin::BusDisturbed:
            return silence;
        case AlarmKin::Drive:
            return silence && cause.about == result.about;
        case AlarmKin::Alone:
        case AlarmKin::Silence:
            break;
    }
    return false;
}

QString buttonText(AlarmHelp help)
{
    switch (help) {
        case AlarmHelp::None:
            return {};
        case AlarmHelp::Rearm:
            return Text::tr("Re-arm");
        case AlarmHelp::ResetStop:
            return Text::tr("Reset stop");
        case AlarmHelp::Unwind:
            return Text::tr("Unwrap now");
        case AlarmHelp::HoldAtEnd:
            return Text::tr("Hold at end");
        case AlarmHelp::Reconnect:
            return Text::tr("Reconnect");
        case AlarmHelp::ParkNow:
            return Text::tr("Park now");
        case AlarmHelp::OverrideWind:
            return Text::tr("Move anyway");
        case AlarmHelp::UseNewTime:
            return Text::tr("Use new time");
        case AlarmHelp::MovePark:
            return Text::tr("Move park");
        case AlarmHelp::OpenProtection:
            return Text::tr("Open Protection");
        case AlarmHelp::OpenDrives:
            return Text::tr("Open Drives");
        case AlarmHelp::OpenClients:
            return Text::tr("Open Clients");
        case AlarmHelp::OpenLimits:
            return Text::tr("Open Limits");
        case AlarmHelp::OpenNorth:
            return Text::tr("Open North");
        case AlarmHelp::OpenProfile:
            return Text::tr("Open Profile");
        case AlarmHelp::ConfirmWrap:
            return Text::tr("Enter position");
        case AlarmHelp::OpenHomeRun:
            return Text::tr("Home run");
        case AlarmHelp::OpenGuide:
            return Text::tr("Open guide");
    }
    return {};
}

}  // namespace boresight
