// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/control/station_control.h"
#include "core/north/axis_trace.h"

#include <optional>

// Watches where the axes are, tick by tick: keeps their trace of the last seconds, and since when nobody knows where
// they are. Station thread only.
namespace boresight {

class AxisObserver
{
public:
    // Control and clock outlive it.
    AxisObserver(const StationControl& control, const Clock& clock) : m_control(control), m_clock(clock) {}

    // Once per tick.
    void tick();
    [[nodiscard]] const AxisTrace& trace() const { return m_trace; }
    [[nodiscard]] std::optional<AxesThen> now() const { return m_trace.now(); }
    // For how long the place of the axes has not been known. Zero: it is known.
    [[nodiscard]] Seconds unseenFor() const;
    // The place is known and both axes stand still, as far as a calibration needs it.
    [[nodiscard]] Result<> standStill() const;

private:
    const StationControl& m_control;
    const Clock& m_clock;
    AxisTrace m_trace;
    std::optional<SteadyTime> m_unseenSince;
};

}  // namespace boresight
