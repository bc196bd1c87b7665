// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotator_box/switched_axis.h"

#include "core/rotator_box/each_step.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace boresight {
namespace {

constexpr std::chrono::seconds kMinute{60};
// If a motor does not turn within this time, the box did not start it, because the axis is at the target.
constexpr std::chrono::seconds kTurnsBy{5};
// This number of readings contains all of the noise.
constexpr int kManyReadings = 8;
constexpr Angle kMostBelieved = Angle::fromDegrees(5.0);  // of a coast; a person or the wind moved it farther
constexpr Angle kOfAStep = Angle::fromDegrees(1e-6);

}  // namespace

void SwitchedAxis::begin()
{
    m_phase = Phase::Stands;
    m_spared = false;
    m_aim = inSteps(place(), m_habits.step);
    m_target.reset();
}

void SwitchedAxis::see(Angle place, SteadyTime now)
{
    const Angle noise = 2.0 * m_habits.count + kOfAStep;
    const bool isNoise = m_readings > 0 && std::max(m_same.max, place) - std::min(m_same.min, place) <= noise;
    m_same.min = isNoise ? std::min(m_same.min, place) : place;
    m_same.max = isNoise ? std::max(m_same.max, place) : place;
    m_readings = isNoise ? m_readings + 1 : 1;
    m_changed = isNoise ? m_changed : now;
    m_isWorn = m_isWorn || (m_phase == Phase::Stands && isMiddleKnown());
    if (m_phase == Phase::Runs) {
        if (m_way * (place - m_reached) > kOfAStep) {
            m_reached = place;
            m_changed = now;
        }
        const bool isThere = m_target && m_way * (*m_target - place) <= 0.5 * m_habits.step;
        m_arrived = isThere ? now : m_arrived;
        m_phase = isThere ? Phase::Coasts : now - m_changed >= kTurnsBy ? Phase::Stands : Phase::Runs;
    } else if (m_phase == Phase::Coasts) {
        const bool settles = now - std::max(m_changed, m_arrived) >= (m_isWorn ? kSettlesWorn : kSettles);
        if (settles || now - m_arrived >= kCoastsFor) {
            if (!m_isWorn) {
                m_same = {.min = place, .max = place};
                m_readings = 1;
            }
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

// A worn potentiometer flickers between three counts. The axis is at the middle one, and any other would start its
// motor.
bool SwitchedAxis::isMiddleKnown() const
{
    return m_habits.count > Angle{} && m_readings >= kManyReadings &&
           m_same.max - m_same.min >= 2.0 * m_habits.count - kOfAStep;
}

bool SwitchedAxis::standsAt(Angle target) const
{
    const Angle near = 0.5 * m_habits.step;
    return m_phase == Phase::Stands && target > m_same.min - near && target < m_same.max + near;
}

bool SwitchedAxis::isOutside(const TravelRange& within) const
{
    const Angle near = 0.5 * m_habits.step + kOfAStep;
    return place() < within.min - near || place() > within.max + near;
}

// Not beyond the leeway.
Angle SwitchedAxis::aimOf(const tracking::Leeway& leeway) const
{
    const Angle wanted =
        std::clamp(leeway.within.clamped(leeway.rest + leeway.lead), place() - kFarthest, place() + kFarthest);
    return stepInside(wanted, m_habits.step, leeway.within);
}

// The motor is switched off earlier by its coast, so that the axis stops at `aim`. A motor that runs keeps such a
// target until the axis is there.
Angle SwitchedAxis::shortened(Angle aim) const
{
    const Angle steps = m_habits.step * std::floor(coast() / m_habits.step + 1e-6);
    const Angle way = aim - place();
    const Angle shorter = inSteps(way > Angle{} ? aim - steps : aim + steps, m_habits.step);
    const bool goesOn = m_phase == Phase::Runs && m_way * way > Angle{};
    const bool isAhead = goesOn ? m_way * (shorter - place()) > Angle{} : abs(way) > steps + m_habits.step;
    return isAhead ? shorter : aim;
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

bool SwitchedAxis::isDue(Angle aim, const tracking::Leeway& leeway, SteadyTime now, bool waits)
{
    const bool isExact = leeway.band == Angle{};
    if (aim == m_aim) {
        return false;
    }
    if (m_phase == Phase::Runs) {
        const bool isOnward = m_way * (aim - *m_aim) > Angle{};
        // The axis may have arrived since its last report. A target a little farther would then start it again.
        const bool isLate = m_way * (leeway.rest - *m_aim) > -0.5 * abs(leeway.lead);
        const bool endsNear = !isExact && leeway.within.contains(*m_aim) &&
                              abs(*m_aim - leeway.rest) <= std::max(leeway.band, m_habits.step);
        return isOnward ? !waits && (isLate || !leeway.follows) : !endsNear;
    }
    if (waits) {
        return false;
    }
    if (isOutside(leeway.within)) {
        return true;  // a limit was moved
    }
    if (isExact) {
        return standsAt(aim) || abs(aim - place()) >= coast();  // otherwise it would stop no nearer
    }
    // A slew and a jog start with their lead, because a person waits for them.
    const Angle band = std::max({leeway.band, m_habits.step, leeway.follows ? coast() : Angle{}});
    const Angle wanted = leeway.follows ? leeway.rest : leeway.rest + leeway.lead;
    if (standsAt(aim) || abs(wanted - place()) < band || (coasts() && leeway.follows)) {
        return false;
    }
    m_spared = leeway.follows && !mayStart(now);
    return !m_spared;
}

// On a slew and in a jog the motor is sent on before it arrives, so it is not switched off earlier by its coast.
Angle SwitchedAxis::targetFor(Angle aim, const tracking::Leeway& leeway) const
{
    const bool isSentOn = leeway.band > Angle{} && !leeway.follows;
    return isSentOn ? aim : shortened(aim);
}

Angle SwitchedAxis::again(const tracking::Leeway& leeway)
{
    m_aim = aimOf(leeway);
    return targetFor(*m_aim, leeway);
}

std::optional<Angle> SwitchedAxis::next(const tracking::Leeway& leeway, SteadyTime now, bool waits)
{
    m_spared = false;
    const Angle aim = aimOf(leeway);
    const Angle target = targetFor(aim, leeway);
    // The coast may be known better than at the start. A target that is farther would start the motor again.
    const bool isEnd = m_phase == Phase::Runs && aim == m_aim && m_target && m_way * (*m_target - target) > Angle{} &&
                       m_way * (target - place()) > m_habits.step;
    if (!isEnd && !isDue(aim, leeway, now, waits)) {
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

std::optional<Angle> SwitchedAxis::unchanged() const
{
    if (m_readings == 0) {
        return std::nullopt;
    }
    const Angle noise = m_readings < kManyReadings ? m_habits.count + kOfAStep : kOfAStep;
    const bool isThere =
        m_target && !isMiddleKnown() && *m_target >= m_same.min - noise && *m_target <= m_same.max + noise;
    return m_target && (m_phase == Phase::Runs || isThere) ? *m_target : inSteps(place(), m_habits.step);
}

MotorStarts SwitchedAxis::starts(SteadyTime now) const
{
    const auto young = std::ranges::count_if(m_starts, [now](SteadyTime start) { return now - start < kMinute; });
    return {.lastMinute = static_cast<int>(young), .total = m_total, .coast = m_coast};
}

}  // namespace boresight
