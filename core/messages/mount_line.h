// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <cstdint>
#include <string>

namespace boresight {

// The connection to the mount: a bus, a port or a socket. Plain value.
struct MountLine
{
    enum class State
    {
        Closed,  // not opened yet, or closed by Boresight
        Up,
        Down,  // present, but no data pass; may recover by itself
        Lost,  // gone; Boresight tries to open it again
    };

    State state = State::Closed;
    QString kind = {};               // a short word for the screen; empty: the screen does not show the line
    QString name = {};               // as in the profile
    QString problem = {};            // what, where, what to do; empty: no problem
    QString condition = {};          // what the device reports of itself, for people; empty: nothing
    std::string sensorOffsets = {};  // of the sensor of the device, as the profile saves them; empty: not known
    std::uint64_t sent = 0;          // frames
    std::uint64_t received = 0;      // frames
    std::uint64_t dropped = 0;       // frames that were lost or unreadable
    std::uint64_t errors = 0;
};

}  // namespace boresight
