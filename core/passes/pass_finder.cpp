// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/passes/pass_finder.h"

#include "core/passes/pass_scan.h"

namespace boresight::passes {

PassList findPasses(const orbit::Sgp4& orbit, const PassSearch& search, const std::stop_token& stop)
{
    return PassScan(orbit, search).run(stop);
}

std::vector<PassList> findPasses(std::span<const SatelliteSearch> searches, const std::stop_token& stop,
                                 const std::function<void(std::size_t finished)>& progress)
{
    std::vector<PassList> all;
    for (const SatelliteSearch& one : searches) {
        PassList found = findPasses(one.orbit, one.search, stop);
        if (stop.stop_requested()) {
            break;
        }
        all.push_back(std::move(found));
        if (progress) {
            progress(all.size());
        }
    }
    return all;
}

}  // namespace boresight::passes
