// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace boresight::app {

// Tells systemd about the service ("READY=1", "STOPPING=1") where it asked for it through NOTIFY_SOCKET; else nothing.
// The protocol is one datagram (sd_notify(3)), so that no library is needed for it.
void notifyService(std::string_view state);

}  // namespace boresight::app
