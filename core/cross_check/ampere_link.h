// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/units/quantity.h"

#include <deque>
#include <optional>

// Whether the difference between sensor and axes follows the current of the motors, whose field disturbs the compass.
// Uses the values of the last minute, each with the mean current at its own time. Pure; station thread.
namespace boresight {

struct CurrentCorrelation
{
    double coefficient = 0.0;  // -1…1
    Angle perAmpere;
};

class AmpereLink
{
public:
    static constexpr Seconds kSpan{60.0};

    // Sum of the absolute currents of both motors, in A. Once per tick.
    void note(SteadyTime now, double amperes);
    // A difference of the sensor, measured during `width` around `middle`.
    void take(SteadyTime middle, Seconds width, Angle difference);
    void forget() { m_pairs.clear(); }

    // Only if it is certain: there are enough values, the current rose and fell more than once (so that it is not the
    // effect of a single motion), and the current explains nearly the whole difference.
    [[nodiscard]] std::optional<CurrentCorrelation> correlation() const;

private:
    struct Note
    {
        SteadyTime time;
        double amperes;
    };
    struct Pair
    {
        SteadyTime time;
        double amperes;
        double degrees;
    };
    [[nodiscard]] int changes(double low, double high) const;

    std::deque<Note> m_notes;
    std::deque<Pair> m_pairs;
};

}  // namespace boresight
