// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/tick_lateness.h"

#include <algorithm>

namespace boresight {

void TickLateness::tick(SteadyTime now)
{
    if (m_last) {
        const Seconds late = std::max(Seconds(now - *m_last) - m_period, Seconds(0.0));
        const auto bin = static_cast<std::size_t>(late / kStep);
        ++m_histogram[std::min(bin, m_histogram.size() - 1)];
        ++m_count;
    }
    m_last = now;
}

Seconds TickLateness::percentile(double share) const
{
    const auto wanted = static_cast<std::uint64_t>(share * static_cast<double>(m_count));
    std::uint64_t seen = 0;
    for (std::size_t bin = 0; bin < m_histogram.size(); ++bin) {
        seen += m_histogram[bin];
        if (seen > wanted || seen == m_count) {
            return kStep * static_cast<double>(bin + 1);
        }
    }
    return {};
}

}  // namespace boresight
