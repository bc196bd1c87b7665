// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <chrono>
#include <string>
#include <vector>

// What is measured on a rotctld server, each scenario on a freshly started one and bounded in time and number.
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

// All scenarios against each TARGET (server.h), one list of figures for each; `duration` is the length of each timed
// one. The servers take turns within a scenario, so that both see the machine in the same mood. Fails when a server
// does not start or a client cannot connect.
[[nodiscard]] Result<std::vector<std::vector<Figure>>> measureServers(const std::vector<std::string>& targets,
                                                                      std::chrono::seconds duration);

}  // namespace boresight::bench
