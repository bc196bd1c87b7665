// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/passes/pass_way.h"

#include "core/orbit/sgp4.h"
#include "core/orbit/topocentric.h"

namespace boresight::ui {

namespace {

constexpr int kSteps = 180;

}  // namespace

targets::SkyWay wayOf(const BookedPass& one, const PassBook& book)
{
    const passes::Pass& pass = one.pass;
    const orbit::Sgp4 orbit(book.elementsOf(one));
    const orbit::Observer observer(book.site);
    const UtcTime::duration length = pass.los.utc - pass.aos.utc;
    auto way = std::make_shared<std::vector<targets::SkyMoment>>();
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

}  // namespace boresight::ui
