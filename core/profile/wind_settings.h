// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/units/sky.h"
#include "core/wind/wind_text.h"

#include <string>

// The anemometer, and from which wind on the mount is parked. Plain values.
namespace boresight::profile {

// What a missing reading means.
enum class WhenSilent
{
    Tell,  // an alarm
    Stow   // the wind counts as too strong
};

// Where a strong wind does the least harm.
enum class StowAt
{
    Park,
    Place  // of its own
};

struct WindSettings
{
    std::string source;  // see wind::parseSource; empty: none
    Seconds poll{5.0};   // from one question to a web server to the next
    wind::Format format;
    double stowAbove = 15.0;     // m/s
    double releaseBelow = 10.0;  // m/s
    Seconds gust{3.0};           // the mean of this time counts
    double calm = 10.0;          // min, below releaseBelow
    Seconds silence{30.0};
    WhenSilent whenSilent = WhenSilent::Tell;
    StowAt stowAt = StowAt::Park;
    AxisPosition place{};       // mechanical angles
    double overrideFor = 15.0;  // min

    [[nodiscard]] bool isRead() const { return !source.empty(); }
    bool operator==(const WindSettings&) const = default;
};

}  // namespace boresight::profile
