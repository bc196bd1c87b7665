// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pointing/mount_model.h"

#include "core/base/text.h"
#include "core/pointing/missing_axis.h"
#include "core/pointing/ranges.h"
#include "core/units/degrees_text.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace boresight::pointing {

double AxisGeometry::turnsPerTurn() const
{
    return sign * (gearIn == GearIn::Host ? gearRatio : 1.0);
}

MotorTurns AxisGeometry::toMotor(Angle angle) const
{
    return MotorTurns::fromTurns((angle + offset).turns() * turnsPerTurn());
}

MotorRate AxisGeometry::toMotor(AngularRate rate) const
{
    return MotorRate::fromTurns(rate.turns() * turnsPerTurn());
}

MotorAcceleration AxisGeometry::toMotor(AngularAcceleration acceleration) const
{
    return MotorAcceleration::fromTurns(acceleration.turns() * turnsPerTurn());
}

Angle AxisGeometry::toAxis(MotorTurns turns) const
{
    return Angle::fromTurns(turns.turns() / turnsPerTurn()) - offset;
}

AngularRate AxisGeometry::toAxis(MotorRate rate) const
{
    return AngularRate::fromTurns(rate.turns() / turnsPerTurn());
}

namespace {

// A target that jitters across an end of the travel (359.9°, 0.1° on a 0…360° mount) must not send the mount round for
// each point. A direction beyond the end by at most this angle is taken as the end. Even a narrow beam is several times
// wider.
const Angle kEndTolerance = Angle::fromDegrees(0.25);

// A collimation keeps the beam from a hole at the zenith. A direction inside the hole counts as reached within this
// angle.
const Angle kHoleTolerance = Angle::fromDegrees(0.5);

// In the middle of a gap both ends are nearly equally near. The mount changes to the other end only if that is nearer
// by this angle.
const Angle kEndPreference = Angle::fromDegrees(1.0);

// Prints an angle just past the limit with enough digits to differ from the limit.
QString past(const QString& sentence, Angle angle, Angle limit)
{
    const int decimals = abs(angle - limit) < Angle::fromDegrees(0.1) ? 2 : 1;
    return sentence.arg(degreesText(angle, decimals), degreesText(limit, decimals));
}

QString lowerAxisReason(Angle angle, const TravelRange& travel, bool isXY)
{
    if (isXY) {
        return angle < travel.min ? past(Text::tr("X axis %1 below limit %2"), angle, travel.min)
                                  : past(Text::tr("X axis %1 above limit %2"), angle, travel.max);
    }
    return angle < travel.min ? past(Text::tr("azimuth axis %1 below limit %2"), angle, travel.min)
                              : past(Text::tr("azimuth axis %1 above limit %2"), angle, travel.max);
}

QString upperAxisReason(Angle angle, const TravelRange& travel, bool isXY)
{
    if (isXY) {
        return angle < travel.min ? past(Text::tr("Y axis %1 below limit %2"), angle, travel.min)
                                  : past(Text::tr("Y axis %1 above limit %2"), angle, travel.max);
    }
    return angle < travel.min ? past(Text::tr("elevation %1 below limit %2"), angle, travel.min)
                              : past(Text::tr("elevation %1 above limit %2"), angle, travel.max);
}

void addReason(Resolved& resolved, const QString& reason)
{
    resolved.limited = true;
    resolved.reason += (resolved.reason.isEmpty() ? QString() : QStringLiteral(", ")) + reason;
}

// The turn of `azimuth` inside the travel that is nearest to `now`. Empty if the azimuth lies in a gap of the travel.
std::optional<Angle> turnInside(const TravelRange& travel, Angle azimuth, Angle now)
{
    const Angle near = azimuth.nearestTo(now);
    if (reaches(travel, near)) {
        return travel.clamped(near);
    }
    const Angle beyond = abs(near - travel.clamped(near));
    if (beyond <= kEndTolerance && abs(near - now) <= 2.0 * kEndTolerance) {
        return travel.clamped(near);
    }
    const double turns = std::ceil((beyond - kRounding) / kFullTurn);
    const Angle back = near + (near > travel.max ? -turns : turns) * kFullTurn;
    return reaches(travel, back) ? std::optional(travel.clamped(back)) : std::nullopt;
}

// The cosine of the angle on the sky between two places: larger is nearer.
double nearness(const AxisPosition& axes, const AxisPosition& wanted)
{
    const double e = axes.elevation.radians();
    const double s = wanted.elevation.radians();
    return std::sin(e) * std::sin(s) + std::cos(e) * std::cos(s) * std::cos((axes.azimuth - wanted.azimuth).radians());
}

// The nearest permitted point when the azimuth has to stay at `end`. The distance on the sky is smallest at the
// elevation atan2(sin E, cos E cos D), where D is the missing azimuth.
AxisPosition nearestAtEnd(const TravelRange& travel, Angle end, const AxisPosition& wanted)
{
    const double missing = (wanted.azimuth - end).radians();
    const double e = wanted.elevation.radians();
    const Angle best = Angle::fromRadians(std::atan2(std::sin(e), std::cos(e) * std::cos(missing)));
    AxisPosition chosen{.azimuth = end, .elevation = travel.clamped(best)};
    for (const Angle elevation : {travel.min, travel.max}) {
        const AxisPosition other{.azimuth = end, .elevation = elevation};
        if (nearness(other, wanted) > nearness(chosen, wanted)) {
            chosen = other;
        }
    }
    return chosen;
}

}  // namespace

MountModel::MountModel(const AxisGeometry& azimuth, const AxisGeometry& elevation, const PointingModel& pointing)
    : m_azimuth(azimuth),
      m_elevation(elevation),
      m_pointing(pointing),
      m_azimuths(azimuth.travel),
      m_elevations(elevation.travel)
{}

void MountModel::setPointing(const PointingModel& pointing)
{
    m_pointing = m_missing ? PointingModel(withoutAxis(pointing.terms(), *m_missing)) : pointing;
}

void MountModel::leaveOut(Axis axis)
{
    m_missing = axis;
    (axis == Axis::Azimuth ? m_azimuth : m_elevation).travel = {};
    (axis == Axis::Azimuth ? m_azimuths : m_elevations) = {};
    setPointing(m_pointing);
}

void MountModel::limitTo(const TravelRange& azimuths, const TravelRange& elevations)
{
    if (azimuths.min <= azimuths.max && elevations.min <= elevations.max) {
        m_azimuths = azimuths;
        m_elevations = elevations;
    }
}

const AxisGeometry& MountModel::axis(Axis which) const
{
    return which == Axis::Azimuth ? m_azimuth : m_elevation;
}

// The axis angles for a direction above 90°, reached over the top.
std::optional<AxisPosition> MountModel::overTheTop(const SkyPointing& direction, const AxisPosition& now) const
{
    const AxisPosition wanted = present(m_pointing.toAxes(direction).axes);
    const auto azimuth = turnInside(m_azimuths, wanted.azimuth, now.azimuth);
    if (m_pointing.isXY() || direction.elevation <= 90_deg || !azimuth || !reaches(m_elevations, wanted.elevation)) {
        return std::nullopt;
    }
    return AxisPosition{.azimuth = *azimuth, .elevation = m_elevations.clamped(wanted.elevation)};
}

Resolved MountModel::resolve(const SkyPointing& direction, const AxisPosition& now) const
{
    if (const auto over = overTheTop(direction, now)) {
        return {.position = *over};
    }
    const auto [axes, miss] = m_pointing.toAxes(upright(direction));
    const AxisPosition wanted = present(axes);
    Resolved resolved;
    if (const auto azimuth = turnInside(m_azimuths, wanted.azimuth, now.azimuth)) {
        resolved.position = {*azimuth, m_elevations.clamped(wanted.elevation)};
    } else {
        resolved.position = nearestAcrossGap(wanted, now);
        addReason(resolved, m_pointing.isXY() ? lowerAxisReason(wanted.azimuth, m_azimuths, true) : gapReason(wanted));
    }
    if (!reaches(m_elevations, wanted.elevation)) {
        addReason(resolved, upperAxisReason(wanted.elevation, m_elevations, m_pointing.isXY()));
    }
    if (resolved.limited && !m_pointing.isIdentity() && !m_pointing.isXY()) {
        resolved.reason += u' ' + Text::tr("(mechanical angles)");
    }
    if (miss > kHoleTolerance) {
        addReason(resolved, Text::tr("the beam misses the zenith by %1").arg(degreesText(miss)));
    }
    return resolved;
}

QString MountModel::gapReason(const AxisPosition& wanted) const
{
    const QString sentence = m_azimuths == m_azimuth.travel ? Text::tr("azimuth %1 outside travel (axis %2…%3)")
                                                            : Text::tr("azimuth %1 outside limits (axis %2…%3)");
    return sentence.arg(azimuthText(wanted.azimuth), degreesText(m_azimuths.min), degreesText(m_azimuths.max));
}

AxisPosition MountModel::nearestAcrossGap(const AxisPosition& wanted, const AxisPosition& now) const
{
    const TravelRange& azimuths = m_azimuths;
    const bool nearMin = abs(now.azimuth - azimuths.min) < abs(now.azimuth - azimuths.max);
    const Angle here = nearMin ? azimuths.min : azimuths.max;
    const Angle there = nearMin ? azimuths.max : azimuths.min;
    const AxisPosition stay = nearestAtEnd(m_elevations, here, wanted);
    const AxisPosition change = nearestAtEnd(m_elevations, there, wanted);
    const auto distance = [&](const AxisPosition& axes) {
        return Angle::fromRadians(std::acos(std::clamp(nearness(axes, wanted), -1.0, 1.0)));
    };
    return distance(change) + kEndPreference < distance(stay) ? change : stay;
}

Resolved MountModel::resolve(const AxisPosition& position) const
{
    const AxisPosition wanted = present(position);
    Resolved resolved{.position = {m_azimuths.clamped(wanted.azimuth), m_elevations.clamped(wanted.elevation)}};
    if (!reaches(m_azimuths, wanted.azimuth)) {
        addReason(resolved, lowerAxisReason(wanted.azimuth, m_azimuths, m_pointing.isXY()));
    }
    if (!reaches(m_elevations, wanted.elevation)) {
        addReason(resolved, upperAxisReason(wanted.elevation, m_elevations, m_pointing.isXY()));
    }
    return resolved;
}

}  // namespace boresight::pointing
