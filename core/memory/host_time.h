// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"

#include <QString>

// What this computer's clocks are worth as a witness. UTC alone proves nothing: it may be stepped, and a computer
// without a battery clock starts at the same wrong time after every power cut. Plain value; hostTime() asks the kernel
// and may be called from any thread.
namespace boresight::memory {

struct HostTime
{
    QString boot;             // the kernel's id of this run of the computer; empty: unknown
    Seconds sinceBoot{0.0};   // steady: no step of the clock touches it
    bool utcIsExact = false;  // the kernel keeps UTC by a time server, known to about a second

    bool operator==(const HostTime&) const = default;
};

[[nodiscard]] HostTime hostTime(const Clock& clock);

}  // namespace boresight::memory
