// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

namespace boresight {

// Keeps a serial port that was opened from the programs of all users, until it is closed. Busy: another one has it; the
// text is its name, as "tview (process 1234)". Nothing else is a failure: some drivers know no locks.
//
// QSerialPort's lock file is seen only by programs that share its folder: not by a service with a /tmp of its own. So
// the device itself is locked, in both ways that there are. The kernel's exclusive mark, which QSerialPort sets, is
// taken from a pseudo-terminal: its other end stays open, and the mark would outlive a killed program.
[[nodiscard]] Result<> claimPort(int descriptor);

}  // namespace boresight
