// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/base/numbers.h"
#include "core/units/quantity.h"

#include <QString>

// Numbers as the operator reads them in a symptom.
namespace boresight::supervision {

[[nodiscard]] inline QString words(double value, int decimals)
{
    return QString::fromStdString(formatFixed(value, decimals));
}
[[nodiscard]] inline QString words(Angle angle)
{
    return words(angle.degrees(), 1) + QStringLiteral("°");
}
[[nodiscard]] inline QString words(AngularRate rate)
{
    return words(rate.degrees(), 1) + QStringLiteral("°/s");
}
[[nodiscard]] inline QString words(Seconds time)
{
    return words(time.count(), 2) + QStringLiteral(" s");
}

}  // namespace boresight::supervision
