// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus_mount/drive_pair.h"

#include "core/survey/protections.h"

namespace boresight {
namespace {

DriveSettings driveSettings(Axis which, const profile::Profile& profile)
{
    const profile::AxisSettings& axis = profile.axis(which);
    const Angle allowance = profile.supervision.encoderJump;
    return {.id = axis.id,
            .watchdog = profile.control.watchdog,
            .maxTorque = axis.maxTorque,
            .velocityLimit = abs(axis.geometry.toMotor(axis.limits.speed)) * survey::kLimitGuard,
            .accelerationLimit = abs(axis.geometry.toMotor(axis.limits.acceleration)) * survey::kLimitGuard,
            .emergencyBraking = abs(axis.geometry.toMotor(survey::emergencyBraking(axis.limits))),
            .places = {.allowance = abs(axis.geometry.toMotor(allowance) - axis.geometry.toMotor(Angle{})),
                       .speed = abs(axis.geometry.toMotor(axis.limits.speed))}};
}

}  // namespace

DrivePair::DrivePair(const profile::InForce& profile)
    : m_profile(profile),
      m_azimuth(driveSettings(Axis::Azimuth, *profile), QT_TRANSLATE_NOOP("Text", "azimuth drive")),
      m_elevation(driveSettings(Axis::Elevation, *profile), QT_TRANSLATE_NOOP("Text", "elevation drive"))
{}

const pointing::AxisGeometry& DrivePair::geometry(Axis axis) const
{
    return m_profile->axis(axis).geometry;
}

void DrivePair::take(const CanFrame& frame)
{
    if (!m_azimuth.take(frame)) {
        m_elevation.take(frame);
    }
}

void DrivePair::judge(SteadyTime now)
{
    for (const Axis axis : kAxes) {
        drive(axis).setSettings(driveSettings(axis, *m_profile));
        drive(axis).judge(now);
    }
}

std::array<CanFrame, 2> DrivePair::frames() const
{
    return {m_azimuth.frame(), m_elevation.frame()};
}

void DrivePair::engage()
{
    m_azimuth.engage();
    m_elevation.engage();
}

void DrivePair::leave(profile::OnExit how)
{
    for (const Axis axis : kAxes) {
        if (drive(axis).phase() == Drive::Phase::Listening) {
            continue;
        }
        switch (how) {
            case profile::OnExit::Hold:
                drive(axis).listen();  // standing still, it holds by its own time-out mode
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
    return m_azimuth.phase() == Drive::Phase::Engaged && m_elevation.phase() == Drive::Phase::Engaged;
}

void DrivePair::seize(SteadyTime now)
{
    for (Drive* const drive : {&m_azimuth, &m_elevation}) {
        if (drive->answering(now)) {
            drive->seize();
        }
    }
}

void DrivePair::excuse(Seconds stall, SteadyTime now)
{
    m_azimuth.excuse(stall, now);
    m_elevation.excuse(stall, now);
}

bool DrivePair::changingHands(const Drive& drive)
{
    const Drive::Phase phase = drive.phase();
    return phase == Drive::Phase::Capturing || phase == Drive::Phase::Recovering ||
           phase == Drive::Phase::Referencing || phase == Drive::Phase::Starving || phase == Drive::Phase::Releasing ||
           phase == Drive::Phase::Unseen;
}

void DrivePair::setSetpoint(Axis axis, Angle angle, AngularRate rate)
{
    drive(axis).setSetpoint(geometry(axis).toMotor(angle), geometry(axis).toMotor(rate));
}

void DrivePair::setHardBraking(bool hard)
{
    m_azimuth.setHardBraking(hard);
    m_elevation.setHardBraking(hard);
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

std::optional<AxisPosition> DrivePair::measured() const
{
    const auto azimuth = measured(Axis::Azimuth);
    const auto elevation = measured(Axis::Elevation);
    return azimuth && elevation ? std::optional(AxisPosition{*azimuth, *elevation}) : std::nullopt;
}

}  // namespace boresight
