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

// The passes of one satellite over one site: what is searched for, and what is found. Geometric directions without
// refraction. Pure values.
namespace boresight::passes {

struct PassSearch
{
    Site site{};
    UtcTime from{};
    UtcTime to{};
    Angle minimumElevation{};
    // Where the antenna sees the sky: its horizon and its keep-outs. Empty: everywhere. It never moves AOS and LOS.
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
    PassMoment aos;              // the minimum elevation is passed upwards, or the span begins
    PassMoment tca;              // the greatest elevation within the pass
    PassMoment los;              // downwards, or the span or the orbit ends
    bool isUpAtStart = false;    // of the span
    bool isUpAtEnd = false;      // of the span or of the orbit
    int maxima = 0;              // of the elevation, between AOS and LOS
    std::vector<Stretch> clear;  // of PassSearch::isClear: several rises in one pass, or none

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

// The theory has no answer from then on: the satellite has decayed, or the elements do not hold.
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
