// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/units/sky.h"

#include <deque>
#include <optional>

// Where the axes were in the last seconds. A value of the sensor is an average and some time old when it arrives, so it
// is compared with the position of the axes at its own time. Pure; station thread.
namespace boresight {

struct AxesThen
{
    AxisPosition place;  // the mean over the requested time
    AxisRates rates;
    double current = 0.0;  // A, of the motor that draws more: the mean, because a compass averages too
};

class AxisTrace
{
public:
    // Longer than the oldest value that the settings of a sensor allow.
    static constexpr Seconds kKept{16.0};

    void note(SteadyTime now, const AxisPosition& place, double current);
    void clear() { m_notes.clear(); }

    // Empty if the axes were not seen during the whole time.
    [[nodiscard]] std::optional<AxesThen> about(SteadyTime middle, Seconds width) const;
    // The newest position.
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
