// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/units/sky.h"

#include <deque>
#include <optional>

// Where the axes were in the last seconds, so that a value of the sensor, which is old and an average when it arrives,
// can be laid beside the place that it is about. Pure; station thread.
namespace boresight {

struct AxesThen
{
    AxisPosition place;  // the mean over the time asked for
    AxisRates rates;
    double current = 0.0;  // A, of the motor that draws more: the mean, as a compass that averages feels it
};

class AxisTrace
{
public:
    // Longer than the oldest value that a sensor's settings allow.
    static constexpr Seconds kKept{16.0};

    void note(SteadyTime now, const AxisPosition& place, double current);
    void clear() { m_notes.clear(); }

    // Empty where the axes were not seen from one end of the time to the other.
    [[nodiscard]] std::optional<AxesThen> about(SteadyTime middle, Seconds width) const;
    // The newest.
    [[nodiscard]] std::optional<AxesThen> now() const;

private:
    struct Note
    {
        SteadyTime time;
        AxisPosition place;
        double current;
    };
    std::deque<Note> m_notes;  // by time
};

}  // namespace boresight
