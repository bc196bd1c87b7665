// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/control/control_parts.h"
#include "core/messages/station_status.h"

#include <optional>
#include <vector>

// The state of the mount and of its axes, in values and words. It is computed from the parts of the control each time
// that it is needed. Decides nothing. Station thread only.
namespace boresight {

class StatusReport
{
public:
    explicit StatusReport(const ControlParts& parts) : m_of(parts) {}

    // A stream whose target is nearer than this to the measured direction is TRACK. Else it is SLEW.
    static constexpr Angle kOnTarget = Angle::fromDegrees(1.0);

    [[nodiscard]] StationState state() const;
    [[nodiscard]] StationStatus status() const;
    // The status without permissions and route, which take most of its time.
    [[nodiscard]] StationStatus brief() const;
    // The set-points of the last tick and the replies of the drives to them. Empty before the first tick.
    [[nodiscard]] std::optional<TickSample> sample() const;
    // Whether both axes are this near to their target.
    [[nodiscard]] bool onTarget(Angle within) const;
    [[nodiscard]] bool arrived() const;  // stands still at the requested place or direction
    // Why the mount goes to the nearest permitted place instead of the target. Empty: it goes to the target.
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
