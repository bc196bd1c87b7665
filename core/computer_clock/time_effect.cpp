// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/computer_clock/time_effect.h"

#include "core/base/text.h"
#include "core/units/angle_between.h"
#include "core/units/degrees_text.h"

namespace boresight {
namespace {

QString shiftOf(const QString& name, const std::optional<SkyPointing>& before, const std::optional<SkyPointing>& after)
{
    return before && after ? Text::tr("%1 would be %2 away").arg(name, degreesText(angleBetween(*before, *after)))
                           : Text::tr("%1 has no direction at the new time").arg(name);
}

}  // namespace

TimeEffect timeEffect(const StationStatus& status, const TargetAt& targetAt, Seconds by)
{
    const bool isTracked = status.tracked && status.tracked->skyRate;
    if (isTracked && status.tracked->isUp) {
        const UtcTime then = status.utc + std::chrono::duration_cast<UtcTime::duration>(by);
        return {.moves = true, .shift = shiftOf(status.tracked->name, targetAt(status.utc), targetAt(then))};
    }
    return {.delays = isTracked || status.schedule->armed};
}

}  // namespace boresight
