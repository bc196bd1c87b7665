// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/control/control_parts.h"
#include "core/messages/station_status.h"

#include <optional>
#include <vector>

// What the control knows, as the world sees it: the state of the mount and of its axes, in values and words. Made again
// from the parts each time that it is asked for; decides nothing. Station thread only.
namespace boresight {

class StatusReport
{
public:
    explicit StatusReport(const ControlParts& parts) : m_of(parts) {}

    // A target within this of the measured direction counts as tracked, not as slewed to.
    static constexpr Angle kOnTarget = Angle::fromDegrees(1.0);

    [[nodiscard]] StationState state() const;
    [[nodiscard]] StationStatus status() const;
    // What the last tick commanded and what the drives have answered to it; empty before the first tick.
    [[nodiscard]] std::optional<TickSample> sample() const;
    // Both axes are this near to where they are sent.
    [[nodiscard]] bool onTarget(Angle within) const;
    [[nodiscard]] bool arrived() const;  // at the place or direction that was asked for, and standing still there
    // Why not the target is driven but the nearest permitted place; empty: it is driven.
    [[nodiscard]] QString limitedReason() const;

private:
    [[nodiscard]] bool aimed() const;
    [[nodiscard]] AxisStatus axisStatus(Axis axis) const;
    [[nodiscard]] std::vector<SkyPointing> route() const;
    [[nodiscard]] AxisSample axisSample(Axis axis) const;
    [[nodiscard]] std::optional<std::chrono::milliseconds> age(const AxisReport& report) const;
    [[nodiscard]] AxisState axisState(Axis axis, const AxisReport& report) const;
    [[nodiscard]] QString axisText(Axis axis, AxisState state, const AxisReport& report) const;
    [[nodiscard]] bool atTravelEnd(Axis axis) const;
    [[nodiscard]] bool atLimit(Axis axis) const;
    [[nodiscard]] std::optional<DrivesStatus> drivesStatus() const;

    ControlParts m_of;
};

}  // namespace boresight
