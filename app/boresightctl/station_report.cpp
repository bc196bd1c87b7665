// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/boresightctl/station_report.h"

#include <QJsonArray>

namespace boresight::ctl {
namespace {

const QString kNotReported = QStringLiteral("not reported over rotctld");

QString directionText(const QJsonObject& report, const QString& key)
{
    if (!report.contains(key)) {
        return kNotReported;
    }
    if (!report[key].isObject()) {
        return QStringLiteral("none");
    }
    const QJsonObject direction = report[key].toObject();
    return QStringLiteral("azimuth %1°, elevation %2°")
        .arg(direction[QStringLiteral("azimuth")].toDouble(), 0, 'f', 2)
        .arg(direction[QStringLiteral("elevation")].toDouble(), 0, 'f', 2);
}

QString actualText(const QJsonObject& report)
{
    const QString key = QStringLiteral("actual");
    return report[key].isObject() ? directionText(report, key) : QStringLiteral("unknown");
}

QString stateText(const QJsonObject& report)
{
    const QString reason = report[QStringLiteral("reason")].toString();
    const QString state = report[QStringLiteral("state")].toString();
    return reason.isEmpty() ? state : QStringLiteral("%1: %2").arg(state, reason);
}

QString alarmsText(const QJsonObject& report)
{
    if (!report.contains(QStringLiteral("alarms"))) {
        return QStringLiteral("alarms:   %1\n").arg(kNotReported);
    }
    const QJsonArray alarms = report[QStringLiteral("alarms")].toArray();
    QString text = QStringLiteral("alarms:   %1\n")
                       .arg(alarms.isEmpty() ? QStringLiteral("none") : QString::number(alarms.size()));
    for (const QJsonValue& value : alarms) {
        const QJsonObject alarm = value.toObject();
        text += QStringLiteral("  %1: %2 %3 %4\n")
                    .arg(alarm[QStringLiteral("severity")].toString(), alarm[QStringLiteral("what")].toString(),
                         alarm[QStringLiteral("action")].toString(), alarm[QStringLiteral("remedy")].toString());
    }
    return text;
}

}  // namespace

QString reportText(const QJsonObject& report)
{
    return QStringLiteral("station:  %1\nstate:    %2\nactual:   %3\ntarget:   %4\ncontrol:  %5\n")
               .arg(report[QStringLiteral("station")].toString(), stateText(report), actualText(report),
                    directionText(report, QStringLiteral("target")),
                    report[QStringLiteral("control")].toString(kNotReported)) +
           alarmsText(report);
}

}  // namespace boresight::ctl
