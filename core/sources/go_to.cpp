// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sources/go_to.h"

#include "core/base/text.h"
#include "core/units/direction_text.h"

#include <algorithm>

namespace boresight::sources {

Result<> GoTo::ask(const request::PointSky& wanted, const Source& by)
{
    const auto place = helm().mayPoint(by).and_then([&] { return helm().placeOf(wanted.direction); });
    if (!place) {
        return tl::make_unexpected(place.error());
    }
    const Angle top = std::max(90_deg, helm().view().model.elevation().travel.max);
    if (wanted.direction.elevation > top) {
        // To a client 95° is the equal direction behind the zenith; an operator who types it has slipped.
        return failure(ErrorCode::OutOfRange,
                       Text::tr("elevation %1 above limit %2")
                           .arg(degreesText(wanted.direction.elevation, 2), degreesText(top, 2)));
    }
    return helm().goToAnyTurn(*place, Activity::Pointing, by,
                              Text::tr("go to %1").arg(directionText(wanted.direction)));
}

Result<> GoTo::ask(const request::PointAxes& wanted, const Source& by)
{
    return helm().goTo(wanted.position, Activity::Pointing, by,
                       Text::tr("go to axes %1").arg(placeText(wanted.position)));
}

}  // namespace boresight::sources
