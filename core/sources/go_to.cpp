// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sources/go_to.h"

#include "core/base/text.h"
#include "core/units/direction_text.h"

namespace boresight::sources {

Result<> GoTo::ask(const request::PointSky& wanted, const Source& by)
{
    return helm()
        .mayPoint(by)
        .and_then([&] { return helm().aimOf(wanted.direction); })
        .and_then([&](const AxisPosition& place) {
            return helm().goToAnyTurn(place, Activity::Pointing, by,
                                      Text::tr("go to %1").arg(directionText(wanted.direction)));
        });
}

Result<> GoTo::ask(const request::PointAxes& wanted, const Source& by)
{
    const QString place = placeText(wanted.position);
    return helm().goTo(wanted.position, Activity::Pointing, by,
                       wanted.purpose.isEmpty() ? Text::tr("go to axes %1").arg(place)
                                                : Text::tr("%1 (axes %2)").arg(wanted.purpose, place));
}

Result<> GoTo::ask(const request::PointAxis& wanted, const Source& by)
{
    const bool azimuth = wanted.axis == Axis::Azimuth;
    const QString what = azimuth ? Text::tr("go to azimuth %1").arg(azimuthText(wanted.angle, 2))
                                 : Text::tr("go to elevation %1").arg(degreesText(wanted.angle, 2));
    const Gates gates(helm().view());
    return helm()
        .mayPoint(by)
        .and_then([&] { return gates.hasAxis(wanted.axis); })
        .and_then([&] { return azimuth ? Result<>{} : gates.isElevation(wanted.angle); })
        .and_then([&] { return helm().placeAlong(wanted.axis, wanted.angle, helm().view().stoppingPlace()); })
        .and_then([&](const AxisPosition& place) {
            return azimuth ? helm().goToAnyTurn(place, Activity::Pointing, by, what)
                           : helm().goTo(place, Activity::Pointing, by, what);
        });
}

}  // namespace boresight::sources
