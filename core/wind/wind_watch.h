// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"

#include <cstddef>
#include <deque>
#include <optional>

// Whether the wind is too strong for the mount, by the mean of the last readings and with two limits. Speeds are in
// m/s. Pure, one thread.
namespace boresight::wind {

// Of the profile.
struct Limits
{
    double stowAbove = 15.0;
    double releaseBelow = 10.0;
    Seconds gust{3.0};           // the mean of this time counts
    Seconds calm{600.0};         // so long below `releaseBelow`
    Seconds silence{30.0};       // without a reading the wind is unknown after this
    bool silenceCounts = false;  // as a wind that is too strong
};

class WindWatch
{
public:
    // Of more readings in the time of the mean the oldest are left out.
    static constexpr std::size_t kMostReadings = 600;

    enum class Cause
    {
        None,
        Wind,
        Silence
    };

    // Readings are expected from now on. What was known is forgotten.
    explicit WindWatch(SteadyTime now) : m_heard(now) {}

    void take(double speed, SteadyTime now);
    // Once in a tick.
    void step(const Limits& limits, SteadyTime now);

    // Why only the stow place is safe. It lasts until the wind was below the lower limit for its time.
    [[nodiscard]] Cause cause() const { return m_cause; }
    // No reading for too long, or none at all.
    [[nodiscard]] bool isSilent() const { return m_isSilent; }
    // The strongest mean since the wind became too strong.
    [[nodiscard]] double peak() const { return m_peak; }
    [[nodiscard]] std::optional<double> last() const
    {
        return m_readings.empty() ? std::nullopt : std::optional(m_readings.back().speed);
    }
    // Of the last reading. Without one: since readings are expected.
    [[nodiscard]] Seconds age(SteadyTime now) const { return now - m_heard; }

private:
    struct Reading
    {
        double speed = 0.0;  // m/s
        SteadyTime arrival;
    };

    void forgetOld(Seconds gust, SteadyTime now);
    [[nodiscard]] std::optional<double> mean() const;
    void judge(const Limits& limits, double mean, SteadyTime now);

    std::deque<Reading> m_readings;  // of the time of the mean, and the last one
    SteadyTime m_heard;
    bool m_isSilent = false;
    Cause m_cause = Cause::None;
    double m_peak = 0.0;
    std::optional<SteadyTime> m_calmSince;
};

}  // namespace boresight::wind
