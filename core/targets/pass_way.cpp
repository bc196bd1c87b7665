// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/targets/pass_way.h"

#include "core/orbit/sgp4.h"
#include "core/orbit/topocentric.h"

namespace boresight::targets {

namespace {

constexpr int kSteps = 180;

}  // namespace

SkyWay wayOf(const passes::Pass& pass, const orbit::ElementSet& elements, const Site& site)
{
    const orbit::Sgp4 orbit(elements);
    const orbit::Observer observer(site);
    const UtcTime::duration length = pass.los.utc - pass.aos.utc;
    auto way = std::make_shared<std::vector<SkyMoment>>();
    for (int step = 0; step <= kSteps; ++step) {
        const UtcTime utc = pass.aos.utc + length * step / kSteps;
        const orbit::JulianDate date = orbit::julianDate(utc);
        if (const auto state = orbit.propagate(date)) {
            way->push_back({.utc = utc,
                            .direction = observer.look(orbit::groundState(*state, date)).direction,
                            .isHidden = !pass.isClearAt(utc)});
        }
    }
    return way;
}

}  // namespace boresight::targets
