// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gs232_mount/switched_motor.h"

#include <algorithm>

namespace boresight::gs232 {

bool SwitchedMotor::starts(Angle place, Angle target) const
{
    const bool turnsRound = m_target && (*m_target > place) != (target > place);
    return target != place && (!m_target || turnsRound);
}

void SwitchedMotor::send(Angle place, Angle target, SteadyTime now)
{
    if (starts(place, target)) {
        std::erase_if(m_lately, [now](SteadyTime start) { return now - start >= kMinute; });
        m_lately.push_back(now);
        ++m_total;
        m_started = now;
    }
    m_target = target != place ? std::optional(target) : std::nullopt;
}

void SwitchedMotor::observe(Angle place, bool moves, SteadyTime now)
{
    const bool there = m_target && abs(*m_target - place) <= kThere;
    if (there || (!moves && now - m_started >= kBegins)) {
        m_target.reset();
    }
}

MotorStarts SwitchedMotor::starts(SteadyTime now) const
{
    const auto lately = std::ranges::count_if(m_lately, [now](SteadyTime start) { return now - start < kMinute; });
    return {.total = m_total, .lastMinute = static_cast<int>(lately)};
}

bool SwitchedMotor::maySend(Angle place, Angle target, int most, SteadyTime now) const
{
    const int lately = starts(now).lastMinute;
    const bool spaced = 2 * lately < most || now - m_started >= kMinute / most;
    return !starts(place, target) || (lately < most && spaced);
}

}  // namespace boresight::gs232
