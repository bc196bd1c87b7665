// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/fitted_box.h"

#include "core/base/text.h"
#include "core/profile/commissioning.h"

#include <algorithm>

namespace boresight::app {
namespace {

bool isBox(const Simulation& asked)
{
    return asked.on && asked.driver && profile::kindOf(*asked.driver).countsItself;
}

}  // namespace

profile::Profile fittedToBox(const Simulation& asked, profile::Profile profile)
{
    if (!isBox(asked)) {
        return profile;
    }
    const bool isEsp32 = asked.device == profile::SimulatedDevice::Esp32;
    const AngularRate most = AngularRate::fromDegrees(isEsp32 ? 2.8 : 6.0);
    const Angle widest = Angle::fromDegrees(isEsp32 ? 350.0 : 450.0);
    for (const Axis axis : kAxes) {
        profile::AxisSettings& mine = axis == Axis::Azimuth ? profile.azimuth : profile.elevation;
        TravelRange travel = mine.geometry.travel;
        if (!profile::kindOf(mine.driver).countsItself) {
            mine.geometry.sign = 1;
            mine.geometry.offset = {};
            mine.limits = {.speed = std::min(mine.limits.speed, most),
                           .acceleration = AngularAcceleration::fromDegrees(3.0),
                           .jerk = AngularJerk::fromDegrees(6.0)};
            travel = {.min = 0_deg, .max = axis == Axis::Azimuth ? 360_deg : 90_deg};
        }
        if (axis == Axis::Azimuth) {
            travel.max = std::min(travel.max, travel.min + widest);
        }
        if (travel != mine.geometry.travel) {
            profile::setTravel(profile, axis, travel);
        }
    }
    return profile;
}

QString folderOfBox(const Simulation& asked)
{
    if (!isBox(asked)) {
        return {};
    }
    const auto* const other = std::ranges::find(profile::kOtherDevices, asked.device, &profile::OtherDevice::device);
    return toQString(other != profile::kOtherDevices.end() ? other->name : profile::kindOf(*asked.driver).name);
}

}  // namespace boresight::app
