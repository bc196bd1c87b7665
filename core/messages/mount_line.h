// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <cstdint>

namespace boresight {

// The line that leads to the mount, whatever it is: a bus, a port, a socket. Plain value.
struct MountLine
{
    enum class State
    {
        Closed,  // not opened yet, or closed by us
        Up,
        Down,  // it is there and carries nothing; may come back by itself
        Lost,  // it is gone, and is opened again
    };

    State state = State::Closed;
    QString kind = {};           // in a short word, for the screen; empty: nothing is shown of it
    QString name = {};           // as the profile names it
    QString problem = {};        // what, where, what to do; empty while all is well
    std::uint64_t sent = 0;      // frames
    std::uint64_t received = 0;  // frames
    std::uint64_t dropped = 0;   // frames that were lost or unreadable
    std::uint64_t errors = 0;
};

}  // namespace boresight
