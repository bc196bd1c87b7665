// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sources/known_places.h"

#include "core/base/text.h"
#include "core/units/degrees_text.h"

#include <algorithm>

namespace boresight::sources {

Result<> KnownPlaces::ask(const request::Home&, const Source& by)
{
    const AxisPosition home = Gates(helm().view()).home();
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
    const auto unwound = helm().mayPoint(by).and_then([this] { return Gates(helm().view()).unwound(); });
    return unwound.and_then([&](const AxisPosition& place) {
        return helm().goTo(place, Activity::Pointing, by,
                           Text::tr("unwind the cable, azimuth to %1").arg(degreesText(place.azimuth, 1)));
    });
}

}  // namespace boresight::sources
