// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sources/known_places.h"

#include "core/base/text.h"
#include "core/units/degrees_text.h"

#include <algorithm>

namespace boresight::sources {

Result<> KnownPlaces::ask(const request::Home&, const Source& by)
{
    const pointing::AxisBox& ranges = helm().view().motion.region().ranges();
    const AxisPosition home{.azimuth = ranges.azimuth.clamped(0_deg), .elevation = ranges.elevation.clamped(0_deg)};
    return helm().goTo(home, Activity::Pointing, by, Text::tr("home to %1").arg(helm().directionText(home)));
}

// Down to 0°, or as far as it goes.
Result<> KnownPlaces::ask(const request::Horizon&, const Source& by)
{
    const pointing::PermittedRegion& region = helm().view().motion.region();
    const AxisPosition here = helm().standing();
    AxisPosition low{.azimuth = here.azimuth, .elevation = 0_deg};
    if (!region.permits(low)) {
        low.elevation = std::max(0_deg, region.elevationsAround(pointing::AxisBox::at(here)).min);
    }
    return helm().goTo(low, Activity::Pointing, by, Text::tr("horizon at %1").arg(helm().directionText(low)));
}

Result<> KnownPlaces::ask(const request::Unwind&, const Source& by)
{
    return helm().mayPoint(by).and_then([&]() -> Result<> {
        const TravelRange& range = helm().view().motion.region().ranges().azimuth;
        const auto place = CableGuard::leastWound(helm().standing(), range);
        if (!place) {
            return failure(ErrorCode::Refused,
                           Text::tr("in this direction the azimuth cable can not be wound less than it is"));
        }
        return helm().goTo(*place, Activity::Pointing, by,
                           Text::tr("unwind the cable, azimuth to %1").arg(degreesText(place->azimuth, 1)));
    });
}

}  // namespace boresight::sources
