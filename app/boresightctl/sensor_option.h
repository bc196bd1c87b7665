// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/sim/simulated_sensor.h"

#include <string>
#include <string_view>

// Errors of the simulated orientation sensor and its mount, as options of the command line: --NAME NUMBER[,NUMBER…],
// for example --sensor-deviation 6,-5,2,2. Pure.
namespace boresight::ctl {

struct SensorOption
{
    std::string_view name;    // without the dashes
    std::string_view values;  // the name of the values in the help: "NORTH,EAST"
    std::string_view text;
    double min = 0.0;  // of each number
    double max = 0.0;
    void (*set)(sim::SensorTruth& truth, const double* numbers);
};

// Null if no option has this name.
[[nodiscard]] const SensorOption* findSensorOption(std::string_view name);

// The error names the option and what it expects.
[[nodiscard]] Result<> takeSensorOption(const SensorOption& option, std::string_view text, sim::SensorTruth& truth);

// Two lines per option, for the help.
[[nodiscard]] std::string sensorHelp();

}  // namespace boresight::ctl
