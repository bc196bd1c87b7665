// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/tick_lateness.h"

#include <algorithm>

namespace boresight {

void TickLateness::tick(SteadyTime now)
{
    if (m_last) {
        const Seconds late = std::max(Seconds(now - *m_last) - m_period, Seconds(0.0));
        const auto bin = static_cast<std::size_t>(late / kStep);
        if (bin < m_fine.size()) {
            ++m_fine[bin];
        } else {
            ++m_coarse[std::min(static_cast<std::size_t>(late / kCoarseStep), m_coarse.size() - 1)];
        }
        m_most = std::max(m_most, late);
        ++m_count;
    }
    m_last = now;
}

Seconds TickLateness::percentile(double share) const
{
    const auto wanted = static_cast<std::uint64_t>(share * static_cast<double>(m_count));
    std::uint64_t seen = 0;
    const auto reached = [&](std::uint64_t more) { return (seen += more) > wanted || seen == m_count; };
    for (std::size_t bin = 0; bin < m_fine.size(); ++bin) {
        if (reached(m_fine[bin])) {
            return std::min(kStep * static_cast<double>(bin + 1), m_most);
        }
    }
    for (std::size_t bin = 0; bin + 1 < m_coarse.size(); ++bin) {
        if (reached(m_coarse[bin])) {
            return std::min(kCoarseStep * static_cast<double>(bin + 1), m_most);
        }
    }
    return m_most;
}

}  // namespace boresight
