// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/local_socket/local_command.h"
#include "core/profile/profile.h"

// A station of this user on this computer, or for root its service, asked by its local socket. Waits for the answer, at
// most kPatience of rotctld_client.h. Error codes: InvalidInput for the station of another computer, Refused with the
// reason of the station, or NoAnswer when nobody answers.
namespace boresight::ctl {

[[nodiscard]] Result<> askLocally(const profile::ListenAddress& station, local::LocalCommand command);

}  // namespace boresight::ctl
