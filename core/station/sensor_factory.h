// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/orientation_stream/sensor_source.h"
#include "core/profile/profile.h"

#include <functional>
#include <memory>

// Makes the source of orientations that a profile names. Not opened yet.
namespace boresight::mqtt {
class Connection;
}

namespace boresight {

struct SimulatedMount;

// Of one program; called on the station thread. The connection is the one to the station's broker and outlives
// what is made. Nothing if the profile names none, or one that cannot be had here.
using SensorMaker =
    std::function<std::unique_ptr<orientation::SensorSource>(const profile::Profile&, mqtt::Connection&)>;

// Of what needs nothing but the profile. `simulated`: the mount whose sensor is the simulated one; may be null. The
// clock outlives the maker and what it makes.
[[nodiscard]] SensorMaker sensorMaker(const Clock& clock, std::shared_ptr<SimulatedMount> simulated);

// Whether the one profile needs another source than the other.
[[nodiscard]] bool namesAnotherSensor(const profile::Profile& a, const profile::Profile& b);

}  // namespace boresight
