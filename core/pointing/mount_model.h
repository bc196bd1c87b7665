// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pointing/pointing_model.h"
#include "core/units/sky.h"

#include <QString>

#include <array>
#include <optional>

// The only place that converts between directions in the sky, mechanical angles of the axes and turns of the motors.
// Pure values, any thread. Requirements: tests/REQUIREMENTS.md.
namespace boresight::pointing {

// Where the gear ratio between motor and axis is applied. A drive that knows the ratio reports turns of the axis, and
// then our factor is 1.
enum class GearIn
{
    Drive,
    Host
};

// motor turns = sign × (angle + offset) / 360° × ratio
struct AxisGeometry
{
    int sign = 1;  // +1 if the motor count grows with the axis angle, else -1
    Angle offset{};
    double gearRatio = 1.0;  // motor turns per turn of the axis
    GearIn gearIn = GearIn::Drive;
    TravelRange travel{};

    [[nodiscard]] MotorTurns toMotor(Angle angle) const;
    [[nodiscard]] MotorRate toMotor(AngularRate rate) const;
    [[nodiscard]] MotorAcceleration toMotor(AngularAcceleration acceleration) const;
    [[nodiscard]] Angle toAxis(MotorTurns turns) const;
    [[nodiscard]] AngularRate toAxis(MotorRate rate) const;

    bool operator==(const AxisGeometry&) const = default;

private:
    [[nodiscard]] double turnsPerTurn() const;  // turns as the drive counts them, per turn of the axis, with sign
};

// The axis angles for a direction. If the axes cannot reach it exactly, `limited` is set and `reason` says why. Then
// the caller decides whether to use the nearest permitted point or to refuse the command.
struct Resolved
{
    AxisPosition position{};  // always inside both ranges
    bool limited = false;
    QString reason{};  // "elevation 95.0° above limit 90.0°"; empty unless limited
};

class MountModel
{
public:
    MountModel(const AxisGeometry& azimuth, const AxisGeometry& elevation, const PointingModel& pointing = {});

    [[nodiscard]] const AxisGeometry& azimuth() const { return m_azimuth; }
    [[nodiscard]] const AxisGeometry& elevation() const { return m_elevation; }
    [[nodiscard]] const AxisGeometry& axis(Axis which) const;

    // The difference between true directions and axis angles. In this class directions are true, positions of the axes
    // are mechanical.
    [[nodiscard]] const PointingModel& pointing() const { return m_pointing; }
    void setPointing(const PointingModel& pointing);

    // The mount has no such axis: its angle is always 0, it is never moved, and no other angle depends on it.
    void leaveOut(Axis axis);
    [[nodiscard]] std::optional<Axis> missing() const { return m_missing; }

    // Limits the result of resolve() to these ranges. The default is the travel of the axes. So a result never lies on
    // a turn outside the soft limits. Empty ranges are ignored.
    void limitTo(const TravelRange& azimuths, const TravelRange& elevations);

    // The axis angles for a direction. Among all turns inside the range it takes the one nearest to `now`, so that a
    // track through north continues as far as the cable allows. `now` is the last target, or the present position if
    // there is none. An elevation above 90° is reached over the top if the travel allows that, else as the equivalent
    // direction (azimuth + 180°, 180° - elevation). An X/Y mount has one way to each direction and no way over the top.
    // For an unreachable direction the result is the nearest permitted point.
    [[nodiscard]] Resolved resolve(const SkyPointing& direction, const AxisPosition& now) const;

    // Takes mechanical angles unchanged. Angles outside the travel become the end of the travel, and `limited` is set.
    [[nodiscard]] Resolved resolve(const AxisPosition& position) const;

    // The direction of the beam: azimuth in [0°, 360°), elevation -90…90°. A beam over the top is converted to its
    // direction in the sky.
    [[nodiscard]] SkyPointing toSky(const AxisPosition& position) const
    {
        return present(upright(m_pointing.toSky(position)));
    }

private:
    // Sets the angle of a missing axis to 0. `Place` is AxisPosition or SkyPointing.
    template <class Place>
    [[nodiscard]] Place present(Place place) const
    {
        place.azimuth = m_missing == Axis::Azimuth ? Angle{} : place.azimuth;
        place.elevation = m_missing == Axis::Elevation ? Angle{} : place.elevation;
        return place;
    }
    [[nodiscard]] std::optional<AxisPosition> overTheTop(const SkyPointing& direction, const AxisPosition& now) const;
    [[nodiscard]] QString gapReason(const AxisPosition& wanted) const;
    [[nodiscard]] AxisPosition nearestAcrossGap(const AxisPosition& wanted, const AxisPosition& now) const;

    AxisGeometry m_azimuth;
    AxisGeometry m_elevation;
    PointingModel m_pointing;
    std::optional<Axis> m_missing;
    TravelRange m_azimuths;
    TravelRange m_elevations;
};

}  // namespace boresight::pointing
