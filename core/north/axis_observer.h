// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/control/station_control.h"
#include "core/north/axis_trace.h"

#include <optional>

// Watches the position of the axes in every tick. Keeps their trace of the last seconds and the time since which the
// position is unknown. Station thread only.
namespace boresight {

class AxisObserver
{
public:
    // Control and clock must outlive it.
    AxisObserver(const StationControl& control, const Clock& clock) : m_control(control), m_clock(clock) {}

    // Once per tick.
    void tick();
    [[nodiscard]] const AxisTrace& trace() const { return m_trace; }
    [[nodiscard]] std::optional<AxesThen> now() const { return m_trace.now(); }
    // For how long the position of the axes has been unknown. Zero: it is known.
    [[nodiscard]] Seconds unseenFor() const;
    // The position is known and both axes stand still enough for a calibration.
    [[nodiscard]] Result<> standStill() const;

private:
    const StationControl& m_control;
    const Clock& m_clock;
    AxisTrace m_trace;
    std::optional<SteadyTime> m_unseenSince;
};

}  // namespace boresight
