// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sources/known_places.h"

#include "core/base/text.h"
#include "core/control/xy_gate.h"
#include "core/units/degrees_text.h"

#include <algorithm>

namespace boresight::sources {
namespace {

// The lowest permitted elevation, at least 0°, at the azimuth of `wanted`. If `wanted` is forbidden, it is the lowest
// elevation of the permitted range around `from`. If `from` is forbidden, too, the search goes up from `wanted`. If no
// elevation is permitted, it is that of `wanted`.
Angle lowest(const pointing::PermittedRegion& region, const AxisPosition& wanted, Angle from)
{
    constexpr Angle kStep = Angle::fromDegrees(0.5);
    const auto at = [&](Angle elevation) {
        return pointing::AxisBox::at({.azimuth = wanted.azimuth, .elevation = elevation});
    };
    Angle above = region.permits(at(from)) && !region.permits(wanted) ? from : wanted.elevation;
    while (!region.permits(at(above)) && above < region.ranges().elevation.max) {
        above = above + kStep;
    }
    return region.permits(at(above)) ? std::max(0_deg, region.elevationsAround(at(above)).min) : wanted.elevation;
}

}  // namespace

Result<> KnownPlaces::ask(const request::Home&, const Source& by)
{
    const AxisPosition home = Gates(helm().view()).home();
    return helm().goTo(home, Activity::Placing, by, Text::tr("home to %1").arg(helm().directionText(home)));
}

// Goes down to 0°, or to the lowest permitted elevation.
Result<> KnownPlaces::ask(const request::Horizon& wanted, const Source& by)
{
    if (Result<> may = hasElevationAxis(helm().view()); !may) {
        return may;
    }
    const pointing::PermittedRegion& region = helm().view().motion.region();
    AxisPosition low{.azimuth = helm().view().stoppingPlace().azimuth,
                     .elevation = std::max(0_deg, region.ranges().elevation.min)};
    if (wanted.azimuth) {
        const auto there =
            helm().mayPoint(by).and_then([&] { return helm().placeAlong(Axis::Azimuth, *wanted.azimuth, low); });
        if (!there) {
            return tl::make_unexpected(there.error());
        }
        low = *there;
    }
    low.elevation = lowest(region, low, helm().standing().elevation);
    const QString what = Text::tr("horizon at %1").arg(helm().directionText(low));
    return wanted.azimuth ? helm().goToAnyTurn(low, Activity::Pointing, by, what)
                          : helm().goTo(low, Activity::Pointing, by, what);
}

Result<> KnownPlaces::ask(const request::Unwind&, const Source& by)
{
    const auto unwound = helm().mayPoint(by).and_then([this] { return hasCable(helm().view()); }).and_then([this] {
        return Gates(helm().view()).unwound();
    });
    return unwound.and_then([&](const AxisPosition& place) {
        return helm().goTo(place, Activity::Placing, by,
                           Text::tr("unwrap the cable, azimuth axis to %1").arg(degreesText(place.azimuth, 1)));
    });
}

}  // namespace boresight::sources
