// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sources/park.h"

#include "core/base/text.h"

namespace boresight::sources {

Result<> Park::ask(const request::Park&, const Source& by)
{
    const AxisPosition place = Gates(helm().view()).park();
    return helm().goTo(place, Activity::Parking, by, Text::tr("park at %1").arg(helm().directionText(place)));
}

}  // namespace boresight::sources
