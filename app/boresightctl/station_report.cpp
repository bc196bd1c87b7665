// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/boresightctl/station_report.h"

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

// Empty: the station has no such output, or is another computer's.
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

}  // namespace

QString reportText(const QJsonObject& report)
{
    return QStringLiteral("station:  %1\nstate:    %2\nactual:   %3\n")
               .arg(report[QStringLiteral("station")].toString(), report[QStringLiteral("state")].toString(),
                    actualText(report[QStringLiteral("actual")])) +
           transmitText(report[QStringLiteral("transmit")].toObject());
}

}  // namespace boresight::ctl
