// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"

#include <cstddef>
#include <deque>
#include <optional>

// Decides whether the wind is too strong for the mount, from the mean of the last readings and two limits. Speeds are
// in m/s. Pure, one thread.
namespace boresight::wind {

// The limits of the profile.
struct Limits
{
    double stowAbove = 15.0;
    double releaseBelow = 10.0;
    Seconds gust{3.0};           // s: time of the mean
    Seconds calm{600.0};         // s: the wind must be below `releaseBelow` for this time
    Seconds silence{30.0};       // s: without a reading for this time the wind is unknown
    bool silenceCounts = false;  // silence counts as a wind that is too strong
};

class WindWatch
{
public:
    // If the time of the mean has more readings, the oldest are dropped.
    static constexpr std::size_t kMostReadings = 600;

    enum class Cause
    {
        None,
        Wind,
        Silence
    };

    // Readings are expected from `now` on. Earlier readings are forgotten.
    explicit WindWatch(SteadyTime now) : m_heard(now) {}

    void take(double speed, SteadyTime now);
    // Once per tick.
    void step(const Limits& limits, SteadyTime now);

    // Why only the stow position is safe. The cause lasts until the wind was below the lower limit for the time `calm`.
    [[nodiscard]] Cause cause() const { return m_cause; }
    // There was no reading for too long, or none at all.
    [[nodiscard]] bool isSilent() const { return m_isSilent; }
    // The strongest mean since the wind became too strong.
    [[nodiscard]] double peak() const { return m_peak; }
    [[nodiscard]] std::optional<double> last() const
    {
        return m_readings.empty() ? std::nullopt : std::optional(m_readings.back().speed);
    }
    // The age of the last reading. Without a reading: the time since readings are expected.
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

    std::deque<Reading> m_readings;  // those within the time of the mean, and at least the last one
    SteadyTime m_heard;
    bool m_isSilent = false;
    Cause m_cause = Cause::None;
    double m_peak = 0.0;
    std::optional<SteadyTime> m_calmSince;
};

}  // namespace boresight::wind
