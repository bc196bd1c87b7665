// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/supervision/motion_memory.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace boresight::supervision {
namespace {

// The shortest commanded way that is judged: ten times backlash and encoder error, a thirtieth of a beam of 10°.
constexpr Angle kAsked = Angle::fromDegrees(0.3);
// An axis that covers this share of the commanded way is moving. The following error judges how well it follows.
constexpr double kMoves = 0.25;
constexpr Angle kMoved = Angle::fromDegrees(0.1);

constexpr AngularRate kAtRest = AngularRate::fromDegrees(0.001);
constexpr Angle kSameSetpoint = Angle::fromDegrees(0.001);

// An axis stands still when it has stayed within kStill for kStillFor. A creeping axis never does: it is measured from
// where it was after kStopsWithin.
constexpr Angle kStill = Angle::fromDegrees(0.1);
constexpr Seconds kStillFor{0.5};
constexpr Seconds kStopsWithin{3.0};

// After a longer time without a reply, command and motion can not be compared.
constexpr Seconds kGap{0.25};

// Whether the set-point was replaced instead of moved. After every stop it is set to the measured place.
bool stepped(Angle from, const AxisObservation& seen, Seconds passed)
{
    return abs(seen.commanded - from) > kMoved + 2.0 * (abs(seen.commandedRate) * passed);
}

}  // namespace

void Progress::forget()
{
    m_anchor.reset();
    m_replies = 0;
}

void Progress::look(const AxisObservation& seen)
{
    const Seconds passed = seen.now - m_last;
    if (!seen.engaged || passed > kGap || stepped(m_lastCommanded, seen, passed)) {
        forget();
    }
    if (const auto place = actual(seen)) {
        compare({.commanded = seen.commanded, .actual = *place}, seen, passed);
    }
    lookAtRate(seen.actual, passed);
    m_last = seen.now;
    m_lastCommanded = seen.commanded;
}

// The set-point plus the median of the last three distances between axis and set-point. Empty before three replies.
std::optional<Angle> Progress::actual(const AxisObservation& seen)
{
    m_behind[m_replies++ % m_behind.size()] = seen.actual - seen.commanded;
    if (m_replies < m_behind.size()) {
        return std::nullopt;
    }
    std::array<Angle, 3> sorted = m_behind;
    std::ranges::sort(sorted);
    return seen.commanded + sorted[1];
}

void Progress::compare(const Anchor& now, const AxisObservation& seen, Seconds passed)
{
    if (!m_anchor) {
        anchorAt(now);
    } else {
        m_asked = now.commanded - m_anchor->commanded;
        m_moved = now.actual - m_anchor->actual;
        m_underCommand += abs(seen.commandedRate) > kAtRest ? passed : Seconds(0.0);
        const bool follows = m_asked / m_moved > 0.0 && abs(m_moved) >= std::max(kMoved, kMoves * abs(m_asked));
        if (follows) {
            anchorAt(now);
        }
    }
}

void Progress::lookAtRate(Angle actual, Seconds passed)
{
    if (passed > Seconds(0.0)) {
        const AngularRate rate = (actual - m_lastActual) / passed;
        const double way = m_asked < Angle{} ? -1.0 : 1.0;
        m_slowsDown = way * rate > AngularRate{} || way * rate > way * m_lastRate;
        m_lastRate = rate;
        m_lastActual = actual;
    }
}

bool Progress::missing() const
{
    return m_anchor && abs(m_asked) >= kAsked && abs(m_moved) < kMoves * abs(m_asked);
}

Angle Progress::against() const
{
    const bool opposed = m_anchor && abs(m_asked) >= kAsked && m_moved / m_asked < 0.0;
    return opposed ? abs(m_moved) : Angle{};
}

void Progress::anchorAt(const Anchor& place)
{
    m_anchor = place;
    m_asked = {};
    m_moved = {};
    m_underCommand = Seconds(0.0);
}

void Standing::look(const AxisObservation& seen)
{
    m_actual = seen.actual;
    if (!shouldStand(seen)) {
        m_rested.reset();
        m_candidate.reset();
        m_since.reset();
        return;
    }
    if (m_rested) {
        return;
    }
    m_since = m_since.value_or(seen.now);
    if (!m_candidate || abs(seen.actual - *m_candidate) > kStill) {
        m_candidate = seen.actual;
        m_still = seen.now;
    }
    if (seen.now - m_still >= kStillFor || seen.now - *m_since >= kStopsWithin) {
        m_rested = m_candidate;
    }
}

std::optional<Angle> Standing::moved() const
{
    return m_rested ? std::optional(m_actual - *m_rested) : std::nullopt;
}

bool Standing::shouldStand(const AxisObservation& seen)
{
    const bool engagedNow = std::exchange(m_lastEngaged, seen.engaged) != seen.engaged;
    const bool moves =
        seen.engaged && (abs(seen.commandedRate) > kAtRest || abs(seen.commanded - m_lastCommanded) > kSameSetpoint);
    m_lastCommanded = seen.commanded;
    return !engagedNow && !moves;
}

void Outside::look(const AxisObservation& seen, const TravelRange& travel)
{
    m_beyond = abs(seen.actual - travel.clamped(seen.actual));
    const Angle outwards = m_beyond - m_reference.value_or(m_beyond);
    if (!m_reference || abs(outwards) > kMoved) {
        m_reference = m_beyond;
        m_moved = seen.now;
        m_outwards = outwards > Angle{};
    } else if (seen.now - m_moved > kStillFor) {
        m_outwards = false;
    }
}

}  // namespace boresight::supervision
