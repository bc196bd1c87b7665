// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/serial/port_claim.h"

#include "core/base/program_lock.h"
#include "core/serial/serial_port_check.h"

#include <sys/ioctl.h>

namespace boresight {

Result<> claimPort(int descriptor)
{
    if (isPseudoTerminal(descriptor)) {
        ioctl(descriptor, TIOCNXCL);
    }
    const Result<> locked = lockDescriptor(descriptor);
    return !locked && locked.error().code == ErrorCode::Busy ? locked : Result<>{};
}

}  // namespace boresight
