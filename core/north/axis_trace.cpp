// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/north/axis_trace.h"

#include <algorithm>
#include <cmath>

namespace boresight {
namespace {

// A gap of a few lost replies does no harm.
constexpr Seconds kGap{0.15};
constexpr Seconds kRateTime{0.2};

}  // namespace

void AxisTrace::note(SteadyTime now, const AxisPosition& place, double current)
{
    if (!m_notes.empty() && Seconds(now - m_notes.back().time) > kGap) {
        m_notes.clear();  // the movement in the gap is unknown
    }
    m_notes.push_back({.time = now, .place = place, .current = std::abs(current)});
    while (Seconds(now - m_notes.front().time) > kKept) {
        m_notes.pop_front();
    }
}

std::optional<AxesThen> AxisTrace::about(SteadyTime middle, Seconds width) const
{
    const auto half = std::chrono::duration_cast<SteadyTime::duration>(width / 2.0);
    const SteadyTime from = middle - half;
    const SteadyTime to = middle + half;
    if (m_notes.empty() || m_notes.front().time > from || m_notes.back().time + kGap < to) {
        return std::nullopt;
    }
    const auto first = std::prev(std::ranges::upper_bound(m_notes, from, {}, &Note::time));
    const auto last = std::prev(std::ranges::upper_bound(m_notes, to, {}, &Note::time));
    AxesThen then;
    double count = 0.0;
    for (auto note = first; note <= last; ++note) {
        then.place.azimuth += note->place.azimuth;
        then.place.elevation += note->place.elevation;
        then.current += note->current;
        count += 1.0;
    }
    then.place = {then.place.azimuth / count, then.place.elevation / count};
    then.current /= count;
    if (last->time > first->time) {
        const Seconds passed(last->time - first->time);
        then.rates = {(last->place.azimuth - first->place.azimuth) / passed,
                      (last->place.elevation - first->place.elevation) / passed};
    }
    return then;
}

std::optional<AxesThen> AxisTrace::now() const
{
    if (m_notes.empty()) {
        return std::nullopt;
    }
    const auto half = std::chrono::duration_cast<SteadyTime::duration>(kRateTime / 2.0);
    auto then = about(m_notes.back().time - half, kRateTime);
    if (then) {
        then->place = m_notes.back().place;
        then->current = m_notes.back().current;
    }
    return then;
}

}  // namespace boresight
