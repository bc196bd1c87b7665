// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/control/standstill_watch.h"

#include <algorithm>

namespace boresight {
namespace {

// An axis stands still while its angles during this time differ by less than this. The noise of an encoder on the axis
// is smaller.
constexpr Angle kSpread = Angle::fromDegrees(0.1);
constexpr std::chrono::seconds kSpreadTime{1};

}  // namespace

void StandstillWatch::look(Axis axis, const AxisReport& report)
{
    auto& [seen, first] = m_places[index(axis)];
    if (!report.place || report.changesHands) {
        seen.clear();  // the angle may be given another value meanwhile
        return;
    }
    if (seen.empty()) {
        first = report.placed;
    }
    if (seen.empty() || report.placed > seen.back().time) {
        seen.push_back({.time = report.placed, .angle = *report.place});
    }
    while (report.placed - seen.front().time > kSpreadTime) {
        seen.pop_front();
    }
}

bool StandstillWatch::moves(Axis axis) const
{
    const auto& seen = m_places[index(axis)].seen;
    if (seen.empty()) {
        return false;
    }
    const auto [least, most] = std::ranges::minmax(seen, {}, &Place::angle);
    return most.angle - least.angle > kSpread;
}

bool StandstillWatch::stands(Axis axis) const
{
    const auto& [seen, first] = m_places[index(axis)];
    return !seen.empty() && seen.back().time - first >= kSpreadTime && !moves(axis);
}

}  // namespace boresight
