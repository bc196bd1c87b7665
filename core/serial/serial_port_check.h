// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <QString>

#include <sys/types.h>

#include <optional>

// Why a serial port cannot be opened, in words that name the remedy. QSerialPort calls nearly everything
// "Permission error".
namespace boresight {

// Looks before opening: is it there, is it a terminal device, may we?
[[nodiscard]] Result<> checkSerialPort(const QString& path);

// The path behind all links, so that every alias of a port shares one lock; the path itself if there is none.
[[nodiscard]] QString canonicalPort(const QString& path);

// Which device stands behind a path. A device that was unplugged and plugged in again is another one.
struct PortIdentity
{
    dev_t fileSystem = 0;
    ino_t file = 0;
    dev_t device = 0;

    bool operator==(const PortIdentity&) const = default;
};
[[nodiscard]] std::optional<PortIdentity> portIdentity(const QString& path);  // empty: nothing is there

// Of a program's making, as by `boresightctl simulate`, and not a port of this computer.
[[nodiscard]] bool isPseudoTerminal(dev_t device);
[[nodiscard]] bool isPseudoTerminal(int descriptor);

}  // namespace boresight
