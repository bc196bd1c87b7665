// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/numbers.h"
#include "core/units/quantity.h"

#include <QString>

// An angle as people read it: degreesText(Angle::fromDegrees(12.345)) is "12.3°"; never "-0.0°".
namespace boresight {

[[nodiscard]] inline QString degreesText(Angle angle, int decimals = 1)
{
    return QString::fromStdString(formatFixed(angle.degrees(), decimals)) + QStringLiteral("°");
}

// An azimuth as people read it, of any turn: never "-0.0°", and what rounds to "360.0°" is "0.0°".
[[nodiscard]] inline QString azimuthText(Angle azimuth, int decimals = 1)
{
    const QString text = degreesText(azimuth.wrapped360(), decimals);
    return text.startsWith(QStringLiteral("360")) ? degreesText({}, decimals) : text;
}

}  // namespace boresight
