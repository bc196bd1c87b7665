// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"

#include <QString>

// How far the clocks of this computer can be trusted. UTC alone proves nothing: it may be set, and a computer without a
// battery clock starts with the same wrong time after every power cut. Plain value; hostTime() reads the kernel and may
// be called from any thread.
namespace boresight::journal {

struct HostTime
{
    QString boot;             // the kernel's id of the present boot; empty: unknown
    Seconds sinceBoot{0.0};   // steady: setting the clock does not change it
    bool utcIsExact = false;  // a time server keeps the UTC of the kernel correct to about a second

    bool operator==(const HostTime&) const = default;
};

[[nodiscard]] HostTime hostTime(const Clock& clock);

}  // namespace boresight::journal
