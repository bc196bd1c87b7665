// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/orientation_stream/sensor_source.h"
#include "core/profile/profile.h"

#include <functional>
#include <memory>

// Makes the orientation sensor that a profile names. The sensor is not opened yet.
namespace boresight::mqtt {
class Connection;
}

namespace boresight {

struct SimulatedMount;

// Makes the sensor of a profile. Called on the station thread. The connection to the broker of the station outlives the
// sensor. Null if the profile names no sensor, or one that does not exist here.
using SensorMaker =
    std::function<std::unique_ptr<orientation::SensorSource>(const profile::Profile&, mqtt::Connection&)>;

// `simulated` is the mount that carries the simulated sensor; it may be null. The clock outlives the maker and the
// sensors that it makes.
[[nodiscard]] SensorMaker sensorMaker(const Clock& clock, std::shared_ptr<SimulatedMount> simulated);

// Whether the two profiles need different sensors.
[[nodiscard]] bool namesAnotherSensor(const profile::Profile& a, const profile::Profile& b);

}  // namespace boresight
