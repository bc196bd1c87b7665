// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/targets/target.h"

#include "core/base/text.h"

#include <algorithm>
#include <iterator>

namespace boresight::targets {

QString satelliteName(const orbit::ElementSet& elements)
{
    return elements.name.empty() ? QString::number(elements.number) : toQString(elements.name);
}

Target satelliteTarget(const orbit::ElementSet& elements)
{
    return {.name = satelliteName(elements), .kind = elements};
}

Target objectTarget(const ephemeris::NamedObject& object)
{
    return {.name = Text::of(object.name), .kind = object.object};
}

std::vector<Target> objectTargets()
{
    std::vector<Target> all;
    std::ranges::transform(ephemeris::namedObjects(), std::back_inserter(all), &objectTarget);
    return all;
}

Target tableTarget(const tables::SharedTable& table)
{
    return {.name = table->name, .kind = table};
}

bool needsSite(const Target& target)
{
    const auto* const table = std::get_if<tables::SharedTable>(&target.kind);
    return table != nullptr ? tables::needsSite(**table) : !std::holds_alternative<SkyPointing>(target.kind);
}

bool stays(const Target& target)
{
    return std::holds_alternative<SkyPointing>(target.kind) || std::holds_alternative<EarthPosition>(target.kind);
}

bool isSun(const Target& target)
{
    const auto* const object = std::get_if<ephemeris::SkyObject>(&target.kind);
    return object != nullptr && *object == ephemeris::SkyObject(ephemeris::Body::Sun);
}

}  // namespace boresight::targets
