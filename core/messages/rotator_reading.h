// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/sky.h"

#include <QString>

// Where another rotator points, as its rotctld reports it. Plain value.
namespace boresight {

struct RotatorReading
{
    QString name;           // "rotctld:10.0.0.7:4533"
    SkyPointing direction;  // as reported: 370° is 370°
};

}  // namespace boresight
