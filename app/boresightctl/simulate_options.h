// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/boresightctl/subcommand.h"
#include "core/base/result.h"
#include "core/mqtt/broker.h"
#include "core/profile/profile.h"
#include "core/sim/simulated_pair.h"
#include "core/sim/simulated_sensor.h"

#include <optional>
#include <string>
#include <vector>

// The command line of `boresightctl simulate`, as values. Pure.
namespace boresight::ctl {

struct SimulateOptions
{
    std::string pty;  // exactly one of these three is set
    std::string can;
    std::optional<profile::ListenAddress> station{};  // a running station, whose simulated mount shows the faults
    std::string sensor;  // link to the pseudo-terminal of the orientation sensor; empty: none
    std::optional<mqtt::Broker> sensorBroker{};
    std::string sensorTopics = "antenna/";
    bool orientationOnly = false;  // only the orientation is sent
    std::string ofSensor;          // an option that was entered and needs a sensor
    sim::SensorTruth sensorTruth = sim::truthToBeFound();
    std::optional<int> azimuthId{};
    std::optional<int> elevationId{};
    bool factory = false;
    bool printTruth = false;
    bool endFaults = false;  // of the station: ends the faults that were asked for before
    std::vector<sim::Injection> injections{};
    std::vector<std::string> faults{};  // the same as text: "wind az:30Nm@5+3"

    [[nodiscard]] sim::PairSettings pairSettings() const;
    [[nodiscard]] bool hasSensor() const { return !sensor.empty() || sensorBroker; }
};

[[nodiscard]] Result<SimulateOptions> parseSimulateOptions(Arguments arguments);

}  // namespace boresight::ctl
