// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sky/slew_way.h"

#include <algorithm>
#include <cmath>

namespace boresight::ui {

namespace {

constexpr Angle kWayStep = Angle::fromDegrees(1.0);

struct AxisWay
{
    Angle from;
    Angle to;
    Seconds time;

    [[nodiscard]] Angle at(Seconds now) const { return time <= now ? to : from + (to - from) * (now / time); }
};

// A mount without this axis stays where it is.
AxisWay wayOf(const AxisStatus& axis, const profile::AxisSettings& settings)
{
    const Angle from = axis.beam.commanded.value_or(0_deg);
    const Angle to = axis.beam.target.value_or(from);
    return {from, to, Seconds(abs(to - from).degrees() / std::max(settings.limits.speed.degrees(), 1e-3))};
}

}  // namespace

bool isSlewing(const StationStatus& status)
{
    return status.state == StationState::Slew || status.slew.has_value();
}

std::vector<SkyPointing> slewWay(const StationStatus& status)
{
    const bool known = status.azimuth.beam.commanded || status.elevation.beam.commanded;
    if (!status.route.empty() || !isSlewing(status) || !known) {
        return status.route;
    }
    const AxisWay azimuth = wayOf(status.azimuth, status.profile->azimuth);
    const AxisWay elevation = wayOf(status.elevation, status.profile->elevation);
    const Seconds whole = std::max(azimuth.time, elevation.time);
    const Angle longest = std::max(abs(azimuth.to - azimuth.from), abs(elevation.to - elevation.from));
    const int steps = static_cast<int>(std::ceil(longest / kWayStep));
    std::vector<SkyPointing> way;
    for (int step = 0; steps > 0 && step <= steps; ++step) {
        const Seconds now = whole * (double(step) / steps);
        way.push_back({azimuth.at(now).wrapped360(), elevation.at(now)});
    }
    return way;
}

}  // namespace boresight::ui
