// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/format.h"

#include "core/base/numbers.h"
#include "core/messages/no_data.h"

#include <QCoreApplication>
#include <QDateTime>

namespace boresight::ui {

namespace {

QString number(double value, int decimals)
{
    return QString::fromStdString(formatFixed(value, decimals));
}

QDateTime dateTime(UtcTime utc)
{
    const auto since = std::chrono::floor<std::chrono::milliseconds>(utc.time_since_epoch());
    return QDateTime::fromMSecsSinceEpoch(since.count(), Qt::UTC);
}

QString pair(const QString& azimuth, Angle elevation)
{
    return QCoreApplication::translate("Format", "az %1  el %2").arg(azimuth, angleText(elevation, 1));
}

}  // namespace

Freshness freshness(const std::optional<std::chrono::milliseconds>& age)
{
    if (!age || *age >= kNoDataAfter) {
        return Freshness::NoData;
    }
    return *age >= kLateAfter ? Freshness::Late : Freshness::Live;
}

QString noValue()
{
    return QStringLiteral("---.--°");
}

QString angleText(Angle angle, int decimals)
{
    return degreesText(angle, decimals);
}

QString signedAngleText(Angle angle, int decimals)
{
    const QString text = angleText(angle, decimals);
    return text.startsWith(QLatin1Char('-')) ? text : QLatin1Char('+') + text;
}

QString rateText(AngularRate rate, int decimals)
{
    return number(rate.degrees(), decimals) + QStringLiteral("°/s");
}

QString directionText(const SkyPointing& direction)
{
    return pair(azimuthText(direction.azimuth, 1), direction.elevation);
}

QString axisText(const AxisPosition& position)
{
    return pair(angleText(position.azimuth, 1), position.elevation);
}

QString ageText(std::chrono::milliseconds age)
{
    return number(Seconds(age).count(), 1) + QStringLiteral(" s");
}

QString waitText(Seconds time)
{
    const double minutes = time.count() / 60.0;
    return time < Seconds(100.0) ? number(time.count(), 0) + QStringLiteral(" s")
           : minutes < 100.0     ? number(minutes, 0) + QStringLiteral(" min")
                                 : number(minutes / 60.0, 0) + QStringLiteral(" h");
}

QString clockText(UtcTime utc)
{
    return dateTime(utc).toString(QStringLiteral("HH:mm:ss"));
}

QString minuteText(UtcTime utc)
{
    return dateTime(utc).toString(QStringLiteral("yyyy-MM-dd HH:mm")) + QLatin1Char('Z');
}

QString dateText(UtcTime utc)
{
    return dateTime(utc).toString(QStringLiteral("yyyy-MM-dd HH:mm:ss.zzz")) + QLatin1Char('Z');
}

}  // namespace boresight::ui
