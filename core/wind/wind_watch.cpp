// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wind/wind_watch.h"

#include <algorithm>
#include <numeric>

namespace boresight::wind {

void WindWatch::take(double speed, SteadyTime now)
{
    m_heard = now;
    m_readings.push_back({.speed = speed, .arrival = now});
    if (m_readings.size() > kMostReadings) {
        m_readings.pop_front();
    }
}

void WindWatch::step(const Limits& limits, SteadyTime now)
{
    forgetOld(limits.gust, now);
    m_isSilent = age(now) > limits.silence;
    if (m_cause == Cause::Silence && !limits.silenceCounts) {
        m_cause = Cause::None;
    }
    if (const auto speed = mean(); speed && !m_isSilent) {
        judge(limits, *speed, now);
        return;
    }
    m_calmSince.reset();
    if (m_isSilent && limits.silenceCounts && m_cause == Cause::None) {
        m_cause = Cause::Silence;
        m_peak = 0.0;
    }
}

void WindWatch::judge(const Limits& limits, double mean, SteadyTime now)
{
    if (mean > limits.stowAbove) {
        m_cause = Cause::Wind;
        m_peak = std::max(m_peak, mean);
    }
    if (mean >= limits.releaseBelow) {
        m_calmSince.reset();
    } else if (!m_calmSince) {
        m_calmSince = now;
    }
    if (m_cause != Cause::None && m_calmSince && now - *m_calmSince >= limits.calm) {
        m_cause = Cause::None;
        m_peak = 0.0;
    }
}

// The last reading counts until the next one, because an anemometer may report less often than once per time of the
// mean.
void WindWatch::forgetOld(Seconds gust, SteadyTime now)
{
    while (m_readings.size() > 1 && now - m_readings.front().arrival >= gust) {
        m_readings.pop_front();
    }
}

std::optional<double> WindWatch::mean() const
{
    if (m_readings.empty()) {
        return std::nullopt;
    }
    const double sum = std::accumulate(m_readings.begin(), m_readings.end(), 0.0,
                                       [](double total, const Reading& one) { return total + one.speed; });
    return sum / static_cast<double>(m_readings.size());
}

}  // namespace boresight::wind
