// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/orbit/sgp4.h"
#include "core/passes/pass.h"

#include <cstddef>
#include <functional>
#include <span>
#include <stop_token>
#include <vector>

// Finds each pass of a satellite in a span of time: none is missed because it is short, and none is invented. Any
// thread. How: README.md.
namespace boresight::passes {

// A stop leaves the passes that were found until then.
[[nodiscard]] PassList findPasses(const orbit::Sgp4& orbit, const PassSearch& search, const std::stop_token& stop = {});

struct SatelliteSearch
{
    orbit::Sgp4 orbit;
    PassSearch search{};
};

// One list for each search, in their order; a stop leaves out those that were not finished. `progress` is called after
// each search with the number of finished ones, in the calling thread. It may be empty.
[[nodiscard]] std::vector<PassList> findPasses(std::span<const SatelliteSearch> searches,
                                               const std::stop_token& stop = {},
                                               const std::function<void(std::size_t finished)>& progress = {});

}  // namespace boresight::passes
