// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/passes/pass_path.h"

#include "core/orbit/sgp4.h"
#include "core/orbit/topocentric.h"

#include <chrono>

namespace boresight::ui {

namespace {

constexpr int kSteps = 180;
constexpr std::chrono::minutes kLongPass{40};

}  // namespace

PassPath pathOf(const BookedPass& one, const PassBook& book)
{
    const passes::Pass& pass = one.pass;
    const orbit::Sgp4 orbit(book.elementsOf(one));
    const orbit::Observer observer(book.site);
    PassPath path;
    const auto add = [&](std::vector<PathPoint>& to, UtcTime utc) {
        const orbit::JulianDate date = orbit::julianDate(utc);
        if (const auto state = orbit.propagate(date)) {
            to.push_back({.utc = utc,
                          .direction = observer.look(orbit::groundState(*state, date)).direction,
                          .isHidden = !pass.isClearAt(utc)});
        }
    };
    const UtcTime::duration length = pass.los.utc - pass.aos.utc;
    for (int step = 0; step <= kSteps; ++step) {
        add(path.points, pass.aos.utc + length * step / kSteps);
    }
    const UtcTime::duration between = length > kLongPass ? std::chrono::hours(1) : std::chrono::minutes(1);
    for (UtcTime mark = std::chrono::ceil<std::chrono::minutes>(pass.aos.utc); mark < pass.los.utc; mark += between) {
        add(path.marks, mark);
    }
    return path;
}

}  // namespace boresight::ui
