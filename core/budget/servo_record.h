// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/units/quantity.h"

#include <deque>
#include <optional>

// How far the axes were beside their set-points in the last seconds, as an angle on the sky. A value. One thread.
namespace boresight::budget {

class ServoRecord
{
public:
    static constexpr Seconds kWindow{10.0};
    static constexpr Seconds kOldAfter{2.0};  // without a measurement for this time nothing is known

    struct Summary
    {
        Angle now;   // the newest measurement
        Angle rms;   // of the window
        Angle peak;  // of the window
    };

    // Times must not decrease.
    void add(SteadyTime time, Angle error);
    // Empty: there is no measurement, or only old ones.
    [[nodiscard]] std::optional<Summary> summary(SteadyTime now) const;

private:
    struct Measured
    {
        SteadyTime time;
        Angle error;
    };
    std::deque<Measured> m_window;  // oldest first; 500 at 50 Hz
};

}  // namespace boresight::budget
