// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pointing/pointing_model.h"
#include "core/units/sky.h"

#include <QString>

#include <array>
#include <optional>

// The one place where a direction in the sky, the mechanical angles of the axes and the turns of the motors become one
// another. Pure values, any thread. Requirements: tests/REQUIREMENTS.md.
namespace boresight::pointing {

// Where the gearbox between motor and axis is reckoned with. When the drive knows the ratio it already reports turns of
// the axis, and the factor on our side is 1.
enum class GearIn
{
    Drive,
    Host
};

// motor turns = sign × (angle + offset) / 360° × ratio
struct AxisGeometry
{
    int sign = 1;  // +1 or -1: does the motor count up when the axis angle grows?
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
    [[nodiscard]] double turnsPerTurn() const;  // signed factor from turns of the axis to turns as the drive counts
};

// How the axes reach a direction. `limited` says that they cannot reach it exactly, and why: the caller decides whether
// the nearest permitted point will do or the command is refused.
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

    // How the true direction differs from what the axes show. Directions are true here, places of the axes mechanical.
    [[nodiscard]] const PointingModel& pointing() const { return m_pointing; }
    void setPointing(const PointingModel& pointing);

    // The mount has no such axis: it stands at 0, nothing is asked of it, and no other angle depends on it.
    void leaveOut(Axis axis);
    [[nodiscard]] std::optional<Axis> missing() const { return m_missing; }

    // Directions are resolved into these ranges, which are the travel of the axes unless set otherwise: a place on a
    // turn outside of the limits of operation is no answer. Ranges with nothing in them change nothing.
    void limitTo(const TravelRange& azimuths, const TravelRange& elevations);

    // The axis angles for a direction: of all turns inside the range the one nearest to `now`, so that a path through
    // north goes on as long as the cable allows. `now` is where the axes are heading (the last target), or where they
    // stand if there is none. Elevation above 90° is taken over the top if the travel allows it, else as the equal
    // direction (azimuth + 180°, 180° - elevation). A direction out of reach gives the permitted point nearest to it.
    [[nodiscard]] Resolved resolve(const SkyPointing& direction, const AxisPosition& now) const;

    // Mechanical angles taken as they are: out-of-travel angles are brought to the end of the travel and `limited`.
    [[nodiscard]] Resolved resolve(const AxisPosition& position) const;

    // Where the beam points: azimuth in [0°, 360°), elevation -90…90° (over the top is turned to its sky place).
    [[nodiscard]] SkyPointing toSky(const AxisPosition& position) const
    {
        return present(upright(m_pointing.toSky(position)));
    }

private:
    // An AxisPosition or a SkyPointing with 0 for an axis that is missing.
    template <class Place>
    [[nodiscard]] Place present(Place place) const
    {
        place.azimuth = m_missing == Axis::Azimuth ? Angle{} : place.azimuth;
        place.elevation = m_missing == Axis::Elevation ? Angle{} : place.elevation;
        return place;
    }
    [[nodiscard]] std::optional<AxisPosition> overTheTop(const SkyPointing& direction, const AxisPosition& now) const;
    [[nodiscard]] AxisPosition nearestAcrossGap(const AxisPosition& wanted, const AxisPosition& now) const;

    AxisGeometry m_azimuth;
    AxisGeometry m_elevation;
    PointingModel m_pointing;
    std::optional<Axis> m_missing;
    TravelRange m_azimuths;
    TravelRange m_elevations;
};

}  // namespace boresight::pointing
