// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sources/go_to.h"

#include "core/base/text.h"
#include "core/units/direction_text.h"

#include <algorithm>

namespace boresight::sources {

// To a client 95° is the equal direction behind the zenith; an operator who types it has slipped.
Result<> GoTo::isElevation(Angle elevation) const
{
    const Angle top = std::max(90_deg, helm().view().model.elevation().travel.max);
    if (elevation > top) {
        return failure(ErrorCode::OutOfRange,
                       Text::tr("elevation %1 above limit %2").arg(degreesText(elevation, 2), degreesText(top, 2)));
    }
    return {};
}

Result<> GoTo::ask(const request::PointSky& wanted, const Source& by)
{
    return helm()
        .mayPoint(by)
        .and_then([&] { return helm().placeOf(wanted.direction); })
        .and_then([&](const AxisPosition& place) {
            return isElevation(wanted.direction.elevation).and_then([&] {
                return helm().goToAnyTurn(place, Activity::Pointing, by,
                                          Text::tr("go to %1").arg(directionText(wanted.direction)));
            });
        });
}

Result<> GoTo::ask(const request::PointAxes& wanted, const Source& by)
{
    return helm().goTo(wanted.position, Activity::Pointing, by,
                       Text::tr("go to axes %1").arg(placeText(wanted.position)));
}

Result<> GoTo::ask(const request::PointAxis& wanted, const Source& by)
{
    const bool azimuth = wanted.axis == Axis::Azimuth;
    const QString what =
        (azimuth ? Text::tr("go to azimuth %1") : Text::tr("go to elevation %1")).arg(degreesText(wanted.angle, 2));
    return helm()
        .mayPoint(by)
        .and_then([&] { return Gates(helm().view()).hasAxis(wanted.axis); })
        .and_then([&] { return azimuth ? Result<>{} : isElevation(wanted.angle); })
        .and_then([&] { return helm().placeAlong(wanted.axis, wanted.angle, helm().view().stoppingPlace()); })
        .and_then([&](const AxisPosition& place) {
            return azimuth ? helm().goToAnyTurn(place, Activity::Pointing, by, what)
                           : helm().goTo(place, Activity::Pointing, by, what);
        });
}

}  // namespace boresight::sources
