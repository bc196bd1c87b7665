// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tuning/tuning_plan.h"

#include "core/base/text.h"
#include "core/units/degrees_text.h"

#include <algorithm>
#include <cmath>

namespace boresight {
namespace {

QString axisText(Axis axis)
{
    return axis == Axis::Azimuth ? Text::tr("azimuth") : Text::tr("elevation");
}

QString obstacleOf(const TuningRoom& room, Axis axis, Angle up, Angle down)
{
    const Angle free = room.bothSides ? std::min(up, down) : std::max(up, down);
    if (free >= room.way) {
        return {};
    }
    return (room.bothSides ? Text::tr("The run needs %1 of free travel on both sides of the %2. There is only %3. Move "
                                      "the axis away from its limits.")
                           : Text::tr("The run needs %1 of free travel on one side of the %2. There is only %3. Move "
                                      "the axis away from its limits."))
        .arg(degreesText(room.way, 2), axisText(axis), degreesText(std::max(free, Angle{}), 2));
}

QString textOf(const TuningPlan& plan, bool bothSides, Axis axis)
{
    const int seconds = static_cast<int>(std::ceil(plan.duration.count()));
    return (bothSides ? Text::tr("Moves the %1 up to ±%2 around axis angle %3 and back, in %4 s.")
                      : Text::tr("Moves the %1 by %2 from axis angle %3 and back, in %4 s."))
        .arg(axisText(axis), degreesText(abs(plan.to - plan.from), 2), degreesText(plan.from, 1))
        .arg(seconds);
}

}  // namespace

TuningWay planTuning(TuningRun run, Axis axis, const AxisPosition& here, const pointing::PermittedRegion& region,
                     const tracking::MotionLimits& limits)
{
    const bool azimuth = axis == Axis::Azimuth;
    const Angle begin = azimuth ? here.azimuth : here.elevation;
    TuningWay found{.plan = {.from = begin, .to = begin}};
    if (!region.permits(here)) {
        found.plan.obstacle = Text::tr("The mount is outside the permitted region. Move it back first.");
        return found;
    }
    const pointing::AxisBox box = pointing::AxisBox::at(here);
    const TravelRange free = azimuth ? region.azimuthsAround(box) : region.elevationsAround(box);
    const TuningRoom room = roomFor(run);
    found.way = free.max - begin >= begin - free.min ? 1.0 : -1.0;
    found.plan.obstacle = obstacleOf(room, axis, free.max - begin, begin - free.min);
    found.legs = legsOf(run, begin, found.way, limits);
    found.plan.to = begin + found.way * farthestOf(found.legs, begin);
    found.plan.duration = durationOf(found.legs, limits);
    found.plan.text = textOf(found.plan, room.bothSides, axis);
    return found;
}

}  // namespace boresight
