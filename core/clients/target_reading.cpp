// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/clients/target_reading.h"

#include "core/base/text.h"
#include "core/pointing/pointing_model.h"
#include "core/units/degrees_text.h"
#include "core/units/direction_text.h"

#include <cmath>
#include <cstdlib>

namespace boresight {
namespace {

constexpr Angle kSame = Angle::fromDegrees(0.05);  // half a step of the one decimal that is shown

bool same(const SkyPointing& one, const SkyPointing& other)
{
    return abs((one.azimuth - other.azimuth).wrapped180()) < kSame && abs(one.elevation - other.elevation) < kSame;
}

QString turnsText(int turns)
{
    switch (turns) {
        case -1:
            return Text::tr("one turn less");
        case 1:
            return Text::tr("one turn more");
        default:
            return (turns < 0 ? Text::tr("%1 turns less") : Text::tr("%1 turns more")).arg(std::abs(turns));
    }
}

// Whether the two are the same end of the circle: 360° and 0°, or -180° and 180°. This does not count as another turn.
bool endOfTheCircle(Angle asked, Angle goal)
{
    const auto near = [](Angle angle, Angle end) { return abs(angle - end) < kSame; };
    return (near(asked, 360_deg) && near(goal, 0_deg)) || (near(asked, 0_deg) && near(goal, 360_deg)) ||
           (near(abs(asked), 180_deg) && near(abs(goal), 180_deg));
}

}  // namespace

QString targetReading(const SkyPointing& asked, const SkyPointing& goal, const QString& limited)
{
    if (!same(pointing::upright(asked), pointing::upright(goal))) {
        const QString place = beamText(pointing::upright(goal));
        return limited.isEmpty() ? place : QStringLiteral("%1: %2").arg(place, limited);
    }
    if (!same(asked, goal)) {
        return Text::tr("%1 (the same direction)").arg(beamText(goal));
    }
    const int turns = static_cast<int>(std::lround((goal.azimuth - asked.azimuth).turns()));
    return turns == 0 || endOfTheCircle(asked.azimuth, goal.azimuth)
               ? QString()
               : Text::tr("az %1 (%2)").arg(degreesText(goal.azimuth), turnsText(turns));
}

}  // namespace boresight
