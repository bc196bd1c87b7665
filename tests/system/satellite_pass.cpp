// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/system/satellite_pass.h"

#include <cmath>

namespace boresight::system_test {
namespace {

constexpr double kEarthRadius = 6371.0;         // km, mean
constexpr double kEarthGravity = 398'600.4418;  // km³/s², WGS 84

}  // namespace

SatellitePass::SatellitePass(const Shape& shape)
    : m_shape(shape),
      m_radius(kEarthRadius + shape.heightKm),
      m_angularRate(std::sqrt(kEarthGravity / (m_radius * m_radius * m_radius)))
{
    const double elevation = shape.maxElevation.radians();
    m_offset = std::acos(kEarthRadius / m_radius * std::cos(elevation)) - elevation;
    const double horizon = kEarthRadius / m_radius;  // cosine of the angle at which the track touches the horizon
    m_halfDuration = Seconds(std::acos(horizon / std::cos(m_offset)) / m_angularRate);
}

// The station is on the z axis. The track crosses the plane of the culmination (x) at right angles, at the offset from
// the station. y is 90° clockwise from x.
SatellitePass::Look SatellitePass::at(Seconds fromCulmination) const
{
    const double along = m_angularRate * fromCulmination.count();
    const double towards = m_radius * std::sin(m_offset) * std::cos(along);
    const double up = m_radius * std::cos(m_offset) * std::cos(along) - kEarthRadius;
    const double aside = m_radius * std::sin(along);
    const double sense = m_shape.sense == Sense::Clockwise ? 1.0 : -1.0;
    return {.azimuth = m_shape.culmination + Angle::fromRadians(sense * std::atan2(aside, towards)),
            .elevation = Angle::fromRadians(std::atan2(up, std::hypot(towards, aside)))};
}

}  // namespace boresight::system_test
