// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/quantity.h"

#include <QString>

#include <cmath>

// Small things that the fits share. Pure.
namespace boresight::calibration {

[[nodiscard]] inline QString inWords(Angle angle, int decimals = 1)
{
    return QString::number(angle.degrees(), 'f', decimals) + QStringLiteral("°");
}

// Of errors that have nothing to do with each other.
[[nodiscard]] inline Angle hypot(Angle a, Angle b)
{
    return Angle::fromRadians(std::hypot(a.radians(), b.radians()));
}

}  // namespace boresight::calibration
