// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/boresightctl/station_report.h"

#include <QJsonArray>

namespace boresight::ctl {
namespace {

QString actualText(const QJsonValue& actual)
{
    if (!actual.isObject()) {
        return QStringLiteral("unknown");
    }
    const QJsonObject direction = actual.toObject();
    return QStringLiteral("azimuth %1°, elevation %2°")
        .arg(direction[QStringLiteral("azimuth")].toDouble(), 0, 'f', 2)
        .arg(direction[QStringLiteral("elevation")].toDouble(), 0, 'f', 2);
}

// Empty: the station has no transmit output, or runs on another computer.
QString transmitText(const QJsonObject& transmit)
{
    if (transmit.isEmpty()) {
        return {};
    }
    QStringList parts{transmit[QStringLiteral("on")].toBool() ? QStringLiteral("on") : QStringLiteral("off")};
    for (const QString& key : {QStringLiteral("problem"), QStringLiteral("whyOff")}) {
        if (const QString text = transmit[key].toString(); !text.isEmpty()) {
            parts << text;
        }
    }
    return QStringLiteral("transmit: %1\n").arg(parts.join(QStringLiteral(". ")));
}

// Empty: the mount has no brake, or the station runs on another computer.
QString brakeText(const QJsonObject& brake)
{
    if (brake.isEmpty()) {
        return {};
    }
    const QString problem = brake[QStringLiteral("problem")].toString();
    return QStringLiteral("brake:    %1\n")
        .arg(brake[QStringLiteral("state")].toString() +
             (problem.isEmpty() ? QString() : QStringLiteral(". ") + problem));
}

// One line for each. Empty: the mount has no end switches, or the station runs on another computer.
QString endSwitchText(const QJsonArray& switches)
{
    QString text;
    for (const QJsonValue& one : switches) {
        const QString problem = one[QStringLiteral("problem")].toString();
        text += QStringLiteral("switch:   %1 %2%3\n")
                    .arg(one[QStringLiteral("end")].toString(), one[QStringLiteral("state")].toString(),
                         problem.isEmpty() ? QString() : QStringLiteral(". ") + problem);
    }
    return text;
}

// Empty: the mount has no third axis, or the station runs on another computer.
QString thirdAxisText(const QJsonObject& axis)
{
    if (axis.isEmpty()) {
        return {};
    }
    const auto number = [&axis](const QString& key, int decimals, const QString& unit) {
        const QJsonValue value = axis[key];
        return value.isDouble() ? QString::number(value.toDouble(), 'f', decimals) + unit : QString();
    };
    const QString angle = number(QStringLiteral("angle"), 2, QStringLiteral("°"));
    QStringList parts{angle.isEmpty() ? QStringLiteral("angle unknown") : angle,
                      axis[QStringLiteral("state")].toString()};
    for (const QString& key : {QStringLiteral("mode"), QStringLiteral("fault")}) {
        parts << axis[key].toString();
    }
    parts << number(QStringLiteral("boardTemperature"), 0, QStringLiteral(" °C"));
    parts.removeAll(QString());
    return QStringLiteral("third:    %1 %2\n")
        .arg(axis[QStringLiteral("name")].toString(), parts.join(QStringLiteral(", ")));
}

// The sum, and a line for each part. Empty: no direction is aimed at, the position is old, or the station runs on
// another computer.
QString budgetText(const QJsonObject& budget)
{
    if (budget.isEmpty()) {
        return {};
    }
    QString text = QStringLiteral("error:    %1\n").arg(budget[QStringLiteral("text")].toString());
    for (const QJsonValue& part : budget[QStringLiteral("parts")].toArray()) {
        const QJsonValue error = part[QStringLiteral("degrees")];
        text += QStringLiteral("  %1%2 %3\n")
                    .arg((part[QStringLiteral("part")].toString() + QLatin1Char(':')).leftJustified(13),
                         error.isDouble() ? QString::number(error.toDouble(), 'f', 3) + QStringLiteral("°.")
                                          : QStringLiteral("not in the sum."),
                         part[QStringLiteral("from")].toString());
    }
    return text;
}

// Empty: the station uses the clock of its computer, or runs on another computer.
QString clockText(const QJsonValue& setBy)
{
    return setBy.isDouble() ? QStringLiteral(
                                  "clock:    set by %1 s. The station uses the old time until "
                                  "use-new-time\n")
                                  .arg(setBy.toDouble(), 0, 'f', 1)
                            : QString();
}

// An old speed is not shown.
QString windReading(const QJsonObject& wind)
{
    const QJsonValue speed = wind[QStringLiteral("speed")];
    if (!speed.isDouble()) {
        return QStringLiteral("unknown, no reading yet");
    }
    const QString age = QString::number(wind[QStringLiteral("age")].toDouble(), 'f', 0);
    return wind[QStringLiteral("silent")].toBool()
               ? QStringLiteral("unknown, no reading for %1 s").arg(age)
               : QStringLiteral("%1 m/s, %2 s old").arg(QString::number(speed.toDouble(), 'f', 1), age);
}

// Empty: the station reads no wind, or runs on another computer.
QString windText(const QJsonObject& wind)
{
    if (wind.isEmpty()) {
        return {};
    }
    QStringList parts{windReading(wind)};
    if (const QString until = wind[QStringLiteral("overriddenUntil")].toString(); !until.isEmpty()) {
        parts << QStringLiteral("Motion is permitted until %1").arg(until);
    }
    if (const QString obstacle = wind[QStringLiteral("obstacle")].toString(); !obstacle.isEmpty()) {
        parts << obstacle;
    }
    return QStringLiteral("wind:     %1\n").arg(parts.join(QStringLiteral(". ")));
}

// Empty: rotctld does not report this key, or its value is empty.
QString lineOf(const QJsonObject& report, const QString& key)
{
    const QString value = report[key].toString();
    return value.isEmpty() ? QString()
                           : QStringLiteral("%1%2\n").arg((key + QLatin1Char(':')).leftJustified(10), value);
}

// A line for each, worst first.
QString alarmLines(const QJsonArray& alarms)
{
    QString lines;
    for (const QJsonValue& alarm : alarms) {
        lines += QStringLiteral("alarm:    %1\n").arg(alarm.toString());
    }
    return lines;
}

}  // namespace

QString reportText(const QJsonObject& report)
{
    return lineOf(report, QStringLiteral("station")) + lineOf(report, QStringLiteral("state")) +
           lineOf(report, QStringLiteral("reason")) + lineOf(report, QStringLiteral("motion")) +
           lineOf(report, QStringLiteral("rises")) + lineOf(report, QStringLiteral("sets")) +
           lineOf(report, QStringLiteral("schedule")) +
           QStringLiteral("actual:   %1\n").arg(actualText(report[QStringLiteral("actual")])) +
           budgetText(report[QStringLiteral("errorBudget")].toObject()) +
           clockText(report[QStringLiteral("clockSetBy")]) + windText(report[QStringLiteral("wind")].toObject()) +
           brakeText(report[QStringLiteral("brake")].toObject()) +
           endSwitchText(report[QStringLiteral("endSwitches")].toArray()) +
           thirdAxisText(report[QStringLiteral("thirdAxis")].toObject()) +
           transmitText(report[QStringLiteral("transmit")].toObject()) +
           alarmLines(report[QStringLiteral("alarms")].toArray());
}

}  // namespace boresight::ctl
