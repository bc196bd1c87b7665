// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/orbit/orbit_state.h"
#include "core/units/site.h"
#include "core/units/sky.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <optional>
#include <vector>

// The passes of one satellite over one site: the parameters of a search and its results. Directions are geometric,
// without refraction. Pure values.
namespace boresight::passes {

struct PassSearch
{
    Site site{};
    UtcTime from{};
    UtcTime to{};
    Angle minimumElevation{};
    // True where the antenna sees the sky: above its horizon and outside its keep-outs. Empty: everywhere. It never
    // changes AOS and LOS.
    std::function<bool(const SkyPointing&)> isClear{};
};

struct PassMoment
{
    UtcTime utc{};
    SkyPointing direction{};

    bool operator==(const PassMoment&) const = default;
};

struct Stretch
{
    UtcTime from{};
    UtcTime to{};

    bool operator==(const Stretch&) const = default;
};

struct Pass
{
    PassMoment aos;              // the satellite rises above the minimum elevation, or the span begins
    PassMoment tca;              // the highest elevation within the pass
    PassMoment los;              // the satellite sets below the minimum elevation, or the span or the orbit ends
    bool isUpAtStart = false;    // already up when the span begins
    bool isUpAtEnd = false;      // still up when the span or the orbit ends
    int maxima = 0;              // number of maxima of the elevation between AOS and LOS
    std::vector<Stretch> clear;  // where PassSearch::isClear is true; may be empty or have several parts

    [[nodiscard]] Seconds duration() const { return los.utc - aos.utc; }
    [[nodiscard]] Seconds clearTime() const
    {
        return std::accumulate(clear.begin(), clear.end(), Seconds(0.0),
                               [](Seconds sum, const Stretch& stretch) { return sum + (stretch.to - stretch.from); });
    }
    [[nodiscard]] bool isClearAt(UtcTime utc) const
    {
        return std::ranges::any_of(clear,
                                   [utc](const Stretch& stretch) { return stretch.from <= utc && utc <= stretch.to; });
    }

    bool operator==(const Pass&) const = default;
};

// The time from which SGP4 has no answer: the satellite has decayed, or the elements are invalid.
struct OrbitEnd
{
    UtcTime utc{};
    orbit::OrbitFault fault = orbit::OrbitFault::Decayed;

    bool operator==(const OrbitEnd&) const = default;
};

struct PassList
{
    std::vector<Pass> passes;  // in the order of time
    std::optional<OrbitEnd> end;

    bool operator==(const PassList&) const = default;
};

}  // namespace boresight::passes
