// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

namespace boresight {

// Keeps other programs of all users from an open serial port, until it is closed. Error Busy: another program has the
// port, and the text is its name, as "tview (process 1234)". No other problem is an error, because some drivers have no
// locks.
//
// Only programs that share the folder see the lock file of QSerialPort. A service with its own /tmp does not see it. So
// the device itself is locked, too, in both possible ways. QSerialPort sets the exclusive mode of the kernel. For a
// pseudo-terminal it is cleared again: the other end stays open, so the mode would outlast a killed program.
[[nodiscard]] Result<> claimPort(int descriptor);

}  // namespace boresight
