// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sources/steered_utc.h"

#include <algorithm>

namespace boresight::sources {

UtcTime SteeredUtc::now(const Clock& clock)
{
    const auto steady = std::chrono::duration_cast<UtcTime::duration>(clock.now().time_since_epoch());
    const UtcTime::duration offset = clock.utc().time_since_epoch() - steady;
    const UtcTime::duration off = m_offset ? offset - *m_offset : UtcTime::duration(0);
    m_jump = Seconds(0.0);
    if (!m_offset || std::chrono::abs(off) > kSet) {
        m_offset = offset;
        m_jump = Seconds(off);
    } else {
        *m_offset += std::clamp(off, UtcTime::duration(-kMost), UtcTime::duration(kMost));
    }
    return UtcTime(steady + *m_offset);
}

}  // namespace boresight::sources
