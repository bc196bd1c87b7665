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

}  // namespace

QString reportText(const QJsonObject& report)
{
    return QStringLiteral("station:  %1\nstate:    %2\nactual:   %3\n")
        .arg(report[QStringLiteral("station")].toString(), report[QStringLiteral("state")].toString(),
             actualText(report[QStringLiteral("actual")]));
}

}  // namespace boresight::ctl
