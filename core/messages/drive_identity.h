// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

// The identity of a drive on the bus. Plain values.
namespace boresight {

struct DriveIdentity
{
    QString uuid;      // 8-4-4-4-12 digits; empty while unknown
    QString firmware;  // "1.1.0"
    int registerMap = 0;

    bool operator==(const DriveIdentity&) const = default;
};

// A board that the last scan of the bus has found.
struct BoardOnBus
{
    int id = 0;
    QString uuid;         // empty: the board did not report it
    bool shared = false;  // another board has the same id: their answers collide

    bool operator==(const BoardOnBus&) const = default;
};

// A board on the bus that the profile does not name.
struct UnknownBoard
{
    int id = 0;
    DriveIdentity identity;

    bool operator==(const UnknownBoard&) const = default;
};

}  // namespace boresight
