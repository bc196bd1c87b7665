// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/orbit/sgp4.h"
#include "core/passes/pass.h"

#include <cstddef>
#include <functional>
#include <span>
#include <stop_token>
#include <vector>

// Finds every pass of a satellite in a span of time, however short it is. Any thread. README.md explains the method.
namespace boresight::passes {

// After a stop the list contains the passes found so far.
[[nodiscard]] PassList findPasses(const orbit::Sgp4& orbit, const PassSearch& search, const std::stop_token& stop = {});

struct SatelliteSearch
{
    orbit::Sgp4 orbit;
    PassSearch search{};
};

// One list for each search, in the same order. After a stop the unfinished searches are missing. `progress` is called
// in the calling thread after each search, with the number of finished searches. It may be empty.
[[nodiscard]] std::vector<PassList> findPasses(std::span<const SatelliteSearch> searches,
                                               const std::stop_token& stop = {},
                                               const std::function<void(std::size_t finished)>& progress = {});

}  // namespace boresight::passes
