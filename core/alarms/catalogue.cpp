// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/alarms/catalogue.h"

namespace boresight {
namespace {

QString severityText(const AlarmEntry& entry)
{
    const QString least = severityWord(entry.severity);
    return entry.worst == entry.severity ? least : QStringLiteral("%1 or %2").arg(least, severityWord(entry.worst));
}

QStringList examplesOf(const AlarmEntry& entry)
{
    QStringList examples;
    for (int i = 0; i < entry.argumentCount(); ++i) {
        examples << QString::fromUtf8(entry.examples[static_cast<std::size_t>(i)]);
    }
    return examples;
}

}  // namespace

QString severityWord(Severity severity)
{
    switch (severity) {
        case Severity::Advisory:
            return QStringLiteral("advisory");
        case Severity::Warning:
            return QStringLiteral("warning");
        case Severity::Alarm:
            break;
    }
    return QStringLiteral("alarm");
}

std::vector<const AlarmEntry*> alarmCatalogue()
{
    std::vector<const AlarmEntry*> all;
    const auto add = [&all](const auto& list) {
        for (const AlarmEntry& entry : list) {
            all.push_back(&entry);
        }
    };
    add(kDriveAlarms);
    add(kAxisAlarms);
    add(kDriveCheckAlarms);
    add(kRotatorAlarms);
    add(kStationAlarms);
    add(kPointingAlarms);
    add(kWindowAlarms);
    return all;
}

QString alarmTable()
{
    QString table = QStringLiteral(
        "| id | severity | what happened | what Boresight did | what to do | button |\n"
        "|---|---|---|---|---|---|\n");
    for (const AlarmEntry* const entry : alarmCatalogue()) {
        const AlarmText text = textOf(*entry, examplesOf(*entry));
        table += QStringLiteral("| `%1` | %2 | %3 | %4 | %5 | %6 |\n")
                     .arg(QLatin1String(entry->id), severityText(*entry), text.what, text.action, text.remedy,
                          buttonText(entry->help));
    }
    return table;
}

}  // namespace boresight
