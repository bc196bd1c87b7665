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
    Places& places = m_places[index(axis)];
    if (!report.place || report.changesHands) {
        places.clear();  // the angle may be given another value meanwhile
        return;
    }
    if (places.empty() || report.placed > places.back().time) {
        places.push_back({.time = report.placed, .angle = *report.place});
    }
    while (report.placed - places.front().time > kSpreadTime) {
        places.pop_front();
    }
}

bool StandstillWatch::moves(Axis axis) const
{
    const Places& places = m_places[index(axis)];
    if (places.empty()) {
        return false;
    }
    const auto [least, most] = std::ranges::minmax(places, {}, &Place::angle);
    return most.angle - least.angle > kSpread;
}

}  // namespace boresight
