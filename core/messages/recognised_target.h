// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <cstdint>

namespace boresight {

// The target of a client, as Boresight recognised it by the points of the client.
struct RecognisedTarget
{
    std::uint64_t clientId = 0;
    QString name;           // of the target
    bool isLocked = false;  // Boresight tracks it from its own orbit. False: the operator may choose this

    bool operator==(const RecognisedTarget&) const = default;
};

}  // namespace boresight
