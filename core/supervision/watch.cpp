// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/supervision/watch.h"

namespace boresight::supervision {
namespace {

// Keeps in `since` when the condition became true. Returns true once the condition has held for `time`.
bool heldFor(std::optional<SteadyTime>& since, bool condition, SteadyTime now, Seconds time)
{
    if (!condition) {
        since.reset();
        return false;
    }
    if (!since) {
        since = now;
    }
    return now - *since >= time;
}

}  // namespace

std::optional<Weight> Watch::judge(SteadyTime now, double value, const WatchLimits& limits)
{
    const bool stop = heldFor(m_stopSince, value >= limits.stop, now, limits.after);
    const bool hint = heldFor(m_hintSince, value >= limits.hint, now, limits.after) || stop;
    const bool quiet = heldFor(m_quietSince, value < limits.release, now, limits.quietFor);
    if (m_observed && quiet) {
        m_observed.reset();
    }
    const bool begins = hint && !m_observed;
    const bool worse = m_observed && stop && m_observed->weight == Weight::Hint;
    const bool doubled = m_observed && m_told > 0.0 && value >= 2.0 * m_told;
    if (!begins && !worse && !doubled) {
        return std::nullopt;
    }
    const bool stops = stop || (m_observed && m_observed->weight == Weight::Stop);
    return stops ? Weight::Stop : Weight::Hint;
}

}  // namespace boresight::supervision
