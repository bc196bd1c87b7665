// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/units/quantity.h"

#include <deque>
#include <optional>

// Whether what the sensor differs from the axes by goes with the current of the motors: their field turns the needle.
// Values of the last minute, each beside the mean current of the time that it is about. Pure; station thread.
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

    // A of both motors together, without sign, once per tick.
    void note(SteadyTime now, double amperes);
    // A difference of the sensor that is about the time around `middle`.
    void take(SteadyTime middle, Seconds width, Angle difference);
    void forget() { m_pairs.clear(); }

    // Only where it is beyond doubt: enough values, a current that rose and fell more than once, so that it is not the
    // one motion that happened, and hardly anything left that it does not explain.
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
