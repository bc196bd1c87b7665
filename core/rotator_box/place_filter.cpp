// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotator_box/place_filter.h"

#include <algorithm>

namespace boresight {
namespace {

bool canBe(Angle from, Angle to, Seconds time)
{
    // Even after a long silence, a jump of a whole turn is not believed at once.
    constexpr Angle kMost = Angle::fromDegrees(180.0);
    return abs(to - from) <= std::min(PlaceFilter::kFastest * time + PlaceFilter::kNoise, kMost);
}

}  // namespace

std::optional<PlaceFilter::Jump> PlaceFilter::take(Angle angle, SteadyTime now)
{
    const SteadyTime before = m_taken;
    m_taken = now;
    const bool agrees = m_doubted && canBe(*m_doubted, angle, now - before);
    // The doubted place is confirmed. It is believed if it is nearer than the last place.
    const bool nearer = agrees && m_place && abs(angle - *m_doubted) < abs(angle - *m_place);
    if (m_place && !nearer && canBe(*m_place, angle, now - m_placed)) {
        believe(angle, now);
        return std::nullopt;
    }
    if (!agrees) {
        m_doubted = angle;
        return std::nullopt;
    }
    const std::optional<Angle> from = m_place;
    believe(angle, now);
    return from ? std::optional(Jump{.from = *from, .to = angle}) : std::nullopt;
}

void PlaceFilter::believe(Angle angle, SteadyTime now)
{
    m_place = angle;
    m_placed = now;
    m_doubted.reset();
}

}  // namespace boresight
