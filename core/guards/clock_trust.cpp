// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/guards/clock_trust.h"

namespace boresight {

bool ClockTrust::update(const Clock& clock, profile::SunClock needed)
{
    const SteadyTime now = clock.now();
    const UtcTime utc = clock.utc();
    const UtcTime::duration offset =
        utc.time_since_epoch() - std::chrono::duration_cast<UtcTime::duration>(now.time_since_epoch());
    if (clock.synchronised()) {
        m_vouched = {.when = now, .offset = offset};
    } else if (m_vouched && (now - m_vouched->when > kKeeps || abs(offset - m_vouched->offset) > kStep)) {
        m_vouched.reset();
    }
    return utc >= kEarliest && (m_vouched || needed == profile::SunClock::Trusted);
}

}  // namespace boresight
