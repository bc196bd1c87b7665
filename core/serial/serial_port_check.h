// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <QString>

#include <sys/types.h>

#include <optional>

// Why a serial port cannot be opened, with the remedy. QSerialPort reports nearly every problem as "Permission error".
namespace boresight {

// Checks before opening: does the port exist, is it a terminal device, do we have the permission?
[[nodiscard]] Result<> checkSerialPort(const QString& path);

// The path with all links resolved, so that every alias of a port shares one lock. The path itself if it does not
// exist.
[[nodiscard]] QString canonicalPort(const QString& path);

// Identifies the device behind a path. A device that was unplugged and plugged in again has another identity.
struct PortIdentity
{
    dev_t fileSystem = 0;
    ino_t file = 0;
    dev_t device = 0;

    bool operator==(const PortIdentity&) const = default;
};
[[nodiscard]] std::optional<PortIdentity> portIdentity(const QString& path);  // empty: no file is there

// A port that a program has made (`boresightctl simulate`), not a port of this computer.
[[nodiscard]] bool isPseudoTerminal(dev_t device);
[[nodiscard]] bool isPseudoTerminal(int descriptor);

}  // namespace boresight
