// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/brake/brake_sequence.h"

namespace boresight::brake {

void BrakeSequence::step(const BrakeInput& input, const BrakeTimes& times, SteadyTime now)
{
    if (input.moves || input.wanted) {
        m_still.reset();
    } else {
        m_still = m_still.value_or(now);
    }
    m_releases = decide(input, times, now);
    if (input.released == m_releases) {
        m_reached = m_reached.value_or(now);
    } else {
        m_reached.reset();
    }
    const bool isDone = m_reached && now - *m_reached >= times.switching;
    if (m_releases) {
        const bool isOpen = isDone || (m_state == BrakeState::Released && m_reached);
        m_state = isOpen ? BrakeState::Released : BrakeState::Releasing;
        m_wasOpen = m_wasOpen || isOpen;
    } else {
        m_state = isDone ? BrakeState::Set : BrakeState::Setting;
        m_wasOpen = false;
    }
}

bool BrakeSequence::decide(const BrakeInput& input, const BrakeTimes& times, SteadyTime now) const
{
    if (input.isLimp) {
        return false;
    }
    if (!m_releases) {
        return input.wanted;
    }
    if (input.isUrgent && !m_wasOpen) {
        return false;  // nothing has moved since the order
    }
    const Seconds patience = input.isBlind ? times.blind : input.isUrgent ? times.urgent : times.setAfter;
    return !m_still || now - *m_still < patience;
}

}  // namespace boresight::brake
