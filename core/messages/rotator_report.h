// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/units/sky.h"

#include <QString>

// Where another rotator points, as its rotctld reports it. Plain value.
namespace boresight {

struct RotatorReport
{
    QString name;  // "rotctld:10.0.0.7:4533"
    Result<SkyPointing>
        direction;  // as reported: 370° is 370°. An error: the reader has given up, and no report follows
};

}  // namespace boresight
