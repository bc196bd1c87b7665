// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <chrono>
#include <string>
#include <vector>

// The measurements on a rotctld server. Each scenario uses a freshly started server, and is limited in time and number.
namespace boresight::bench {

enum class Better
{
    Higher,
    Lower,
};

struct Figure
{
    std::string name;  // with its unit: "get_pos, 10 clients: p99 [µs]"
    double value = 0;  // NaN: not available for this server
    Better better = Better::Lower;
};

// Runs all scenarios with each TARGET (server.h). Returns one list of figures for each. `duration` is the length of
// each timed scenario. The servers take turns within a scenario, so that both see the same load of the computer. Fails
// when a server does not start or a client cannot connect.
[[nodiscard]] Result<std::vector<std::vector<Figure>>> measureServers(const std::vector<std::string>& targets,
                                                                      std::chrono::seconds duration);

}  // namespace boresight::bench
