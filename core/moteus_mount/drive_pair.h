// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/moteus_mount/drive.h"
#include "core/profile/in_force.h"
#include "core/tracking/axis_setpoints.h"
#include "core/units/sky.h"

#include <vector>

// The drives of the mount in the units of the axes: mechanical angles go in and come out, converted with the geometry
// of the profile. The mount has one drive for each axis, or one drive for one axis only. The drive of an axis that is
// not in `axes` is never queried or commanded, and no frame counts as its reply. Pure, like Drive.
namespace boresight {

// The settings of the profile in the units of the drive.
[[nodiscard]] DriveSettings driveSettings(const profile::AxisSettings& axis, const profile::Profile& profile);

class DrivePair
{
public:
    // The profile outlives this.
    DrivePair(const profile::InForce& profile, AxisSet axes);

    [[nodiscard]] AxisSet axes() const { return m_axes; }  // the axes that have a drive
    [[nodiscard]] Drive& drive(Axis axis) { return axis == Axis::Azimuth ? m_azimuth : m_elevation; }
    [[nodiscard]] const Drive& drive(Axis axis) const { return axis == Axis::Azimuth ? m_azimuth : m_elevation; }

    void take(const CanFrame& frame);
    // Once per tick. From here on, the torque and the limits of speed and acceleration are those of the profile in
    // force.
    void judge(SteadyTime now);
    [[nodiscard]] std::vector<CanFrame> frames() const;  // azimuth, elevation

    void engage();
    void seize(SteadyTime now);  // ends what a drive that answers does without our commands
    void excuse(Seconds stall, SteadyTime now);
    [[nodiscard]] bool engaged() const;  // all drives accept set-points
    // The drive is being captured, recovered, switched off or given its position. If commands ended in the middle of
    // that, nothing would hold the axis.
    [[nodiscard]] static bool changingHands(const Drive& drive);
    void leave(profile::OnExit how);  // drives that were never engaged stay as they are
    void setSetpoint(Axis axis, const tracking::Setpoint& setpoint);
    void setHardBraking(bool hard);

    // The position that is believed, of any age. See Drive::place().
    [[nodiscard]] std::optional<Angle> measured(Axis axis) const;
    // As last reported, of any age.
    [[nodiscard]] std::optional<AngularRate> measuredRate(Axis axis) const;

private:
    [[nodiscard]] const pointing::AxisGeometry& geometry(Axis axis) const;

    const profile::InForce& m_profile;
    AxisSet m_axes;
    Drive m_azimuth;
    Drive m_elevation;
};

}  // namespace boresight
