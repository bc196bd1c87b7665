// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotator_box/switched_axis.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace boresight {
namespace {

constexpr std::chrono::seconds kMinute{60};
// A motor that was switched on and is not seen to turn: the box knew that it is there.
constexpr std::chrono::seconds kTurnsBy{5};
// So many readings have all the noise in them.
constexpr int kManyReadings = 8;
constexpr Angle kMostBelieved = Angle::fromDegrees(5.0);  // of a coast; more was a hand or the wind
constexpr Angle kOfAStep = Angle::fromDegrees(1e-6);

Angle rounded(Angle angle, Angle step)
{
    return step * std::round(angle / step);
}

}  // namespace

void SwitchedAxis::begin()
{
    m_phase = Phase::Stands;
    m_spared = false;
    m_aim = rounded(place(), m_habits.step);
    m_target.reset();
}

void SwitchedAxis::see(Angle place, SteadyTime now)
{
    const Angle noise = 2.0 * m_habits.count + kOfAStep;
    const bool isNoise = m_readings > 0 && std::max(m_high, place) - std::min(m_low, place) <= noise;
    m_low = isNoise ? std::min(m_low, place) : place;
    m_high = isNoise ? std::max(m_high, place) : place;
    m_readings = isNoise ? m_readings + 1 : 1;
    m_changed = isNoise ? m_changed : now;
    if (m_phase == Phase::Runs) {
        if (m_way * (place - m_reached) > kOfAStep) {
            m_reached = place;
            m_changed = now;
        }
        const bool isThere = m_target && m_way * (*m_target - place) <= 0.5 * m_habits.step;
        m_arrived = isThere ? now : m_arrived;
        m_phase = isThere ? Phase::Coasts : now - m_changed >= kTurnsBy ? Phase::Stands : Phase::Runs;
    } else if (m_phase == Phase::Coasts) {
        const bool settles = now - std::max(m_changed, m_arrived) >= kSettles;
        if (settles || now - m_arrived >= kCoastsFor) {
            m_low = m_high = place;
            m_readings = 1;
            settle();
        }
    }
}

void SwitchedAxis::settle()
{
    m_phase = Phase::Stands;
    if (m_target) {
        const Angle beyond = std::clamp(m_way * (place() - *m_target), Angle{}, kMostBelieved);
        m_coast = m_coast ? 0.75 * *m_coast + 0.25 * beyond : beyond;
    }
}

bool SwitchedAxis::standsAt(Angle target) const
{
    const Angle near = 0.5 * m_habits.step;
    return m_phase == Phase::Stands && target > m_low - near && target < m_high + near;
}

// Not beyond the leeway. In one without any step the nearest step has to do.
Angle SwitchedAxis::aimOf(const tracking::Leeway& leeway) const
{
    const Angle wanted =
        std::clamp(leeway.within.clamped(leeway.rest + leeway.lead), place() - kFarthest, place() + kFarthest);
    Angle aim = rounded(wanted, m_habits.step);
    if (aim > leeway.within.max + kOfAStep) {
        aim -= m_habits.step;
    } else if (aim < leeway.within.min - kOfAStep) {
        aim += m_habits.step;
    }
    const bool isInside = aim <= leeway.within.max + kOfAStep && aim >= leeway.within.min - kOfAStep;
    return isInside ? aim : rounded(wanted, m_habits.step);
}

// The motor is switched off so much earlier, and ends there.
Angle SwitchedAxis::shortened(Angle aim) const
{
    const Angle steps = m_habits.step * std::floor(coast() / m_habits.step + 1e-6);
    const Angle way = aim - place();
    const Angle shorter = rounded(way > Angle{} ? aim - steps : aim + steps, m_habits.step);
    return abs(way) > steps + m_habits.step ? shorter : aim;
}

bool SwitchedAxis::mayStart(SteadyTime now) const
{
    const auto young =
        static_cast<int>(std::ranges::count_if(m_starts, [now](SteadyTime start) { return now - start < kMinute; }));
    if (m_habits.mostStarts == 0 || 2 * young < m_habits.mostStarts) {
        return true;
    }
    return young < m_habits.mostStarts && now - m_starts.back() >= kMinute / m_habits.mostStarts;
}

bool SwitchedAxis::isDue(Angle aim, const tracking::Leeway& leeway, SteadyTime now)
{
    const bool isExact = leeway.band == Angle{};
    if (aim == m_aim) {
        return false;
    }
    if (m_phase == Phase::Runs) {
        const bool isOnward = m_way * (aim - *m_aim) > Angle{};
        // It may be there already, unseen: sent on for a little it would start again.
        const bool isLate = m_way * (leeway.rest - *m_aim) > -0.5 * abs(leeway.lead);
        const bool endsNear = !isExact && abs(*m_aim - leeway.rest) <= std::max(leeway.band, m_habits.step);
        return isOnward ? isLate || !leeway.follows() : !endsNear;
    }
    if (isExact) {
        return standsAt(aim) || abs(aim - place()) >= coast();  // else it would end no nearer
    }
    const Angle band = std::max({leeway.band, m_habits.step, coast()});
    if (standsAt(aim) || abs(leeway.rest - place()) < band || (coasts() && leeway.follows())) {
        return false;
    }
    m_spared = leeway.follows() && !mayStart(now);
    return !m_spared;
}

std::optional<Angle> SwitchedAxis::next(const tracking::Leeway& leeway, SteadyTime now)
{
    m_spared = false;
    const Angle aim = aimOf(leeway);
    const bool isSentOn = leeway.band > Angle{} && !leeway.follows();
    const Angle target = isSentOn ? aim : shortened(aim);
    const bool isEnd =
        m_phase == Phase::Runs && aim == m_aim && target != m_target && m_way * (target - place()) > m_habits.step;
    if (!isEnd && !isDue(aim, leeway, now)) {
        return std::nullopt;
    }
    m_aim = aim;
    return target;
}

void SwitchedAxis::sent(Angle target, SteadyTime now)
{
    m_target = target;
    const double way = target < place() ? -1.0 : 1.0;
    const bool goesOn = m_phase == Phase::Runs && way == m_way;
    if (standsAt(target) || goesOn) {
        return;
    }
    m_way = way;
    m_phase = Phase::Runs;
    m_reached = place();
    m_changed = now;
    std::erase_if(m_starts, [now](SteadyTime start) { return now - start >= kMinute; });
    m_starts.push_back(now);
    ++m_total;
}

void SwitchedAxis::stopped(SteadyTime now)
{
    m_phase = m_phase == Phase::Runs ? Phase::Coasts : m_phase;
    m_arrived = now;
    m_target.reset();
    m_spared = false;
}

Angle SwitchedAxis::unchanged() const
{
    const Angle noise = m_readings < kManyReadings ? m_habits.count + kOfAStep : kOfAStep;
    const bool isThere = m_target && *m_target >= m_low - noise && *m_target <= m_high + noise;
    return m_target && (m_phase == Phase::Runs || isThere) ? *m_target : rounded(place(), m_habits.step);
}

MotorStarts SwitchedAxis::starts(SteadyTime now) const
{
    const auto young = std::ranges::count_if(m_starts, [now](SteadyTime start) { return now - start < kMinute; });
    return {.lastMinute = static_cast<int>(young), .total = m_total, .coast = m_coast};
}

}  // namespace boresight
