// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"

#include <optional>
#include <string_view>

namespace boresight::app {

// Tells systemd about the service ("READY=1", "STOPPING=1") where it asked for it through NOTIFY_SOCKET; else nothing.
// The protocol is one datagram (sd_notify(3)), so that no library is needed for it.
// Waits while systemd does not read, unless `wait` is false: what the control loop sends may be lost.
void notifyService(std::string_view state, bool wait = true);

// Proves to systemd that the control loop ticks, where it asked for it (WatchdogSec= of the unit): at half the time
// that it grants, and only while somebody calls feed().
class ServiceWatchdog
{
public:
    ServiceWatchdog();

    void feed(SteadyTime now);

private:
    std::optional<SteadyTime::duration> m_period;  // empty: nobody asked
    std::optional<SteadyTime> m_fed;
};

}  // namespace boresight::app
