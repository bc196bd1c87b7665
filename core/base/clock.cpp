// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/clock.h"

namespace boresight {

SteadyTime SystemClock::now() const
{
    return std::chrono::steady_clock::now();
}

UtcTime SystemClock::utc() const
{
    return std::chrono::system_clock::now();
}

}  // namespace boresight
