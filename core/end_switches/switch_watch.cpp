// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/end_switches/switch_watch.h"

namespace boresight::end_switches {

void SwitchWatch::step(const std::optional<bool>& isPressed, SteadyTime now)
{
    m_wasRead = m_wasRead || isPressed.has_value();
    if (!isPressed.has_value() || *isPressed) {
        m_freeSince.reset();
        m_state = isPressed ? SwitchState::Pressed : SwitchState::Unread;
        return;
    }
    m_freeSince = m_freeSince.value_or(now);
    if (m_state != SwitchState::Pressed || now - *m_freeSince >= kSettle) {
        m_state = SwitchState::Free;
    }
}

}  // namespace boresight::end_switches
