// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/numbers.h"
#include "core/units/quantity.h"

#include <QString>

// An angle as a text for people: degreesText(Angle::fromDegrees(12.345)) is "12.3°". Never "-0.0°".
namespace boresight {

[[nodiscard]] inline QString degreesText(Angle angle, int decimals = 1)
{
    return QString::fromStdString(formatFixed(angle.degrees(), decimals)) + QStringLiteral("°");
}

// An azimuth of any turn as a text for people. Never "-0.0°". A value that would round to "360.0°" becomes "0.0°".
[[nodiscard]] inline QString azimuthText(Angle azimuth, int decimals = 1)
{
    const QString text = degreesText(azimuth.wrapped360(), decimals);
    return text.startsWith(QStringLiteral("360")) ? degreesText({}, decimals) : text;
}

}  // namespace boresight
