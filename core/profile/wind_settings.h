// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/units/sky.h"
#include "core/wind/wind_text.h"

#include <string>

// The settings of the anemometer and of the wind limits. Plain values.
namespace boresight::profile {

// What happens if no reading arrives.
enum class WhenSilent
{
    Tell,  // raise an alarm
    Stow   // park the mount as in a strong wind
};

// Where the mount parks in a strong wind.
enum class StowAt
{
    Park,
    Place  // WindSettings::place, where the wind does the least harm
};

struct WindSettings
{
    std::string source;  // see wind::parseSource; empty: none
    Seconds poll{5.0};   // time between two requests to a web server
    wind::Format format;
    double stowAbove = 15.0;     // m/s
    double releaseBelow = 10.0;  // m/s
    Seconds gust{3.0};           // the mean of the readings in this time counts
    double calm = 10.0;          // min, the wind must stay below releaseBelow for this time
    Seconds silence{30.0};
    WhenSilent whenSilent = WhenSilent::Tell;
    StowAt stowAt = StowAt::Park;
    AxisPosition place{};       // mechanical angles
    double overrideFor = 15.0;  // min, how long the operator may move the mount in a strong wind

    [[nodiscard]] bool isRead() const { return !source.empty(); }
    bool operator==(const WindSettings&) const = default;
};

}  // namespace boresight::profile
