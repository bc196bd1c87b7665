// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/elements/element_set.h"
#include "core/passes/pass.h"
#include "core/units/site.h"

#include <vector>

// Whether the Sun shines on a satellite during its pass. Pure. A call takes some milliseconds.
namespace boresight::passes {

struct PassLight
{
    bool isSunlitFirst = false;    // when the satellite rises
    std::vector<UtcTime> changes;  // to the second, between sunlight and shadow

    bool operator==(const PassLight&) const = default;
};

[[nodiscard]] PassLight lightOf(const Pass& pass, const orbit::ElementSet& elements, const Site& site);
// How much of the pass is in sunlight.
[[nodiscard]] Seconds sunlitTime(const Pass& pass, const PassLight& light);

}  // namespace boresight::passes
