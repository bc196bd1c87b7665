// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/quantity.h"

#include <QString>

#include <cmath>

// Small functions that the fits share. Pure.
namespace boresight::calibration {

[[nodiscard]] inline QString inWords(Angle angle, int decimals = 1)
{
    return QString::number(angle.degrees(), 'f', decimals) + QStringLiteral("°");
}

// The combined size of two independent errors.
[[nodiscard]] inline Angle hypot(Angle a, Angle b)
{
    return Angle::fromRadians(std::hypot(a.radians(), b.radians()));
}

}  // namespace boresight::calibration
