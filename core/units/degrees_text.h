// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/numbers.h"
#include "core/units/quantity.h"

#include <QString>

// An angle as people read it: degreesText(Angle::fromDegrees(12.345)) is "12.3°".
namespace boresight {

[[nodiscard]] inline QString degreesText(Angle angle, int decimals = 1)
{
    return QString::fromStdString(formatFixed(angle.degrees(), decimals)) + QStringLiteral("°");
}

}  // namespace boresight
