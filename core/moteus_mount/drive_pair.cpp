// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus_mount/drive_pair.h"

#include "core/tracking/emergency_braking.h"

#include <algorithm>

namespace boresight {

DriveSettings driveSettings(const profile::AxisSettings& axis, const profile::Profile& profile)
{
    const Angle allowance = profile.supervision.encoderJump;
    return {.id = axis.id,
            .watchdog = profile.control.watchdog,
            .maxTorque = axis.maxTorque,
            .tick = profile.control.tickPeriod(),
            .speed = abs(axis.geometry.toMotor(axis.limits.speed)),
            .velocityLimit = abs(axis.geometry.toMotor(axis.limits.speed)) * tracking::kLimitGuard,
            .accelerationLimit = abs(axis.geometry.toMotor(axis.limits.acceleration)) * tracking::kLimitGuard,
            .emergencyBraking = abs(axis.geometry.toMotor(tracking::emergencyBraking(axis.limits))),
            .places = {.allowance = abs(axis.geometry.toMotor(allowance) - axis.geometry.toMotor(Angle{})),
                       .speed = abs(axis.geometry.toMotor(axis.limits.speed))}};
}

DrivePair::DrivePair(const profile::InForce& profile, AxisSet axes)
    : m_profile(profile),
      m_axes(axes),
      m_azimuth(driveSettings(profile->azimuth, *profile), QT_TRANSLATE_NOOP("Text", "azimuth drive")),
      m_elevation(driveSettings(profile->elevation, *profile), QT_TRANSLATE_NOOP("Text", "elevation drive"))
{}

const pointing::AxisGeometry& DrivePair::geometry(Axis axis) const
{
    return m_profile->axis(axis).geometry;
}

void DrivePair::take(const CanFrame& frame)
{
    (void)std::ranges::any_of(m_axes, [&](Axis axis) { return drive(axis).take(frame); });
}

void DrivePair::judge(SteadyTime now)
{
    for (const Axis axis : m_axes) {
        drive(axis).setSettings(driveSettings(m_profile->axis(axis), *m_profile));
        drive(axis).judge(now);
    }
}

std::vector<CanFrame> DrivePair::frames() const
{
    std::vector<CanFrame> frames;
    frames.reserve(kAxes.size() + 1);  // the mount adds that of a third axis
    for (const Axis axis : m_axes) {
        frames.push_back(drive(axis).frame());
    }
    return frames;
}

void DrivePair::engage()
{
    for (const Axis axis : m_axes) {
        drive(axis).engage();
    }
}

void DrivePair::leave(profile::OnExit how)
{
    for (const Axis axis : m_axes) {
        if (drive(axis).phase() == Drive::Phase::Listening) {
            continue;
        }
        switch (how) {
            case profile::OnExit::Hold:
                drive(axis).listen();  // when it stands still, the drive holds it by its time-out mode
                break;
            case profile::OnExit::Brake:
                drive(axis).brake();
                break;
            case profile::OnExit::Off:
                drive(axis).release();
                break;
        }
    }
}

bool DrivePair::engaged() const
{
    return std::ranges::all_of(m_axes, [this](Axis axis) { return drive(axis).phase() == Drive::Phase::Engaged; });
}

void DrivePair::seize(SteadyTime now)
{
    for (const Axis axis : m_axes) {
        if (drive(axis).answering(now)) {
            drive(axis).seize();
        }
    }
}

void DrivePair::excuse(Seconds stall, SteadyTime now)
{
    for (const Axis axis : m_axes) {
        drive(axis).excuse(stall, now);
    }
}

bool DrivePair::changingHands(const Drive& drive)
{
    const Drive::Phase phase = drive.phase();
    return phase == Drive::Phase::Capturing || phase == Drive::Phase::Recovering ||
           phase == Drive::Phase::Referencing || phase == Drive::Phase::Starving || phase == Drive::Phase::Releasing ||
           phase == Drive::Phase::Unseen;
}

void DrivePair::setSetpoint(Axis axis, const tracking::Setpoint& setpoint)
{
    const pointing::AxisGeometry& gear = geometry(axis);
    drive(axis).setSetpoint({.position = gear.toMotor(setpoint.position),
                             .rate = gear.toMotor(setpoint.rate),
                             .acceleration = gear.toMotor(setpoint.acceleration)});
}

void DrivePair::setHardBraking(bool hard)
{
    for (const Axis axis : m_axes) {
        drive(axis).setHardBraking(hard);
    }
}

std::optional<Angle> DrivePair::measured(Axis axis) const
{
    const auto& place = drive(axis).place();
    return place ? std::optional(geometry(axis).toAxis(place->position)) : std::nullopt;
}

std::optional<AngularRate> DrivePair::measuredRate(Axis axis) const
{
    const auto& report = drive(axis).report();
    return report && report->rate ? std::optional(geometry(axis).toAxis(*report->rate)) : std::nullopt;
}

}  // namespace boresight
