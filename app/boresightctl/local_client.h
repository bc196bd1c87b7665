// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/boresightctl/rotctld_client.h"
#include "core/local_socket/local_command.h"
#include "core/profile/profile.h"

#include <QDeadlineTimer>
#include <QLocalSocket>

#include <chrono>
#include <functional>

// A station of this user on this computer, or for root its service, asked by its local socket. Waits for the socket at
// most kPatience of rotctld_client.h, and then for the answer. Error codes: InvalidInput for the station of another
// computer, Refused with the reason of the station, or NoAnswer when nobody answers.
namespace boresight::ctl {

[[nodiscard]] local::LocalAnswer askLocally(const profile::ListenAddress& station, const local::LocalRequest& request,
                                            std::chrono::seconds patience = kPatience);

// Whether askLocally() finds a socket without waiting for it.
[[nodiscard]] bool hasLocalSocket(const profile::ListenAddress& station);

// Connects to the path of this moment, by the deadline. `pause` comes between two attempts: a station that reconnects
// has no socket for a moment.
[[nodiscard]] bool connectBy(const QDeadlineTimer& deadline, const std::function<QString()>& path, QLocalSocket& socket,
                             const std::function<void()>& pause);

}  // namespace boresight::ctl
