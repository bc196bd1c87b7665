// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace boresight::profile {

// What Boresight does when it recognises the target that a client tracks.
enum class ClientLock
{
    Always,  // it tracks the target from its own orbit as soon as the points move along the target
    Ask,     // the window offers this
    Never    // only the points of the client move the mount
};

}  // namespace boresight::profile
