// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"

#include <optional>
#include <string_view>

namespace boresight::app {

// Reports the state of the service to systemd ("READY=1", "STOPPING=1") if NOTIFY_SOCKET is set. Otherwise does
// nothing. The protocol is one datagram (sd_notify(3)), so no library is needed. `wait`: waits while systemd does not
// read. The control loop passes false, so its messages may be lost.
void notifyService(std::string_view state, bool wait = true);

// Proves to systemd that the control loop ticks, if the unit sets WatchdogSec=. It notifies systemd at half of that
// time, and only while feed() is called.
class ServiceWatchdog
{
public:
    ServiceWatchdog();

    void feed(SteadyTime now);

private:
    std::optional<SteadyTime::duration> m_period;  // empty: no watchdog is requested
    std::optional<SteadyTime> m_fed;
};

}  // namespace boresight::app
