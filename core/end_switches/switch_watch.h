// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/end_switches/end_switch.h"

#include <optional>

// The state of one end switch. A contact that bounces counts as pressed until it was free for some time. Pure: time is
// passed in.
namespace boresight::end_switches {

class SwitchWatch
{
public:
    static constexpr std::chrono::milliseconds kSettle{300};

    // Once per tick. Empty: the switch cannot be read now.
    void step(const std::optional<bool>& isPressed, SteadyTime now);

    [[nodiscard]] SwitchState state() const { return m_state; }
    // It was read at least once.
    [[nodiscard]] bool wasRead() const { return m_wasRead; }

private:
    SwitchState m_state = SwitchState::Unread;
    bool m_wasRead = false;
    std::optional<SteadyTime> m_freeSince;
};

}  // namespace boresight::end_switches
