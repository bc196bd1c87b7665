// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/boresightctl/rotctld_client.h"
#include "core/local_socket/local_command.h"
#include "core/profile/profile.h"

#include <QDeadlineTimer>
#include <QLocalSocket>

#include <chrono>
#include <functional>

// Asks a station of this user on this computer (for root: the service) through its local socket. Waits for the socket
// at most kPatience of rotctld_client.h, and then for the answer. Error codes: InvalidInput for a station on another
// computer, Refused with the reason of the station, NoAnswer if nobody answers.
namespace boresight::ctl {

[[nodiscard]] local::LocalAnswer askLocally(const profile::ListenAddress& station, const local::LocalRequest& request,
                                            std::chrono::seconds patience = kPatience);

// Whether the local socket exists now.
[[nodiscard]] bool hasLocalSocket(const profile::ListenAddress& station);

// Connects before the deadline. Calls `path` before each attempt and `pause` between two attempts, because a station
// that reconnects has no socket for a moment.
[[nodiscard]] bool connectBy(const QDeadlineTimer& deadline, const std::function<QString()>& path, QLocalSocket& socket,
                             const std::function<void()>& pause);

}  // namespace boresight::ctl
