// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/units/sky.h"

// A satellite on a circular orbit around a spherical Earth that does not rotate. This gives the true shape of a low
// pass. Times are seconds from culmination.
namespace boresight::system_test {

class SatellitePass
{
public:
    enum class Sense
    {
        Clockwise,
        CounterClockwise
    };
    struct Shape
    {
        double heightKm = 400.0;
        Angle maxElevation;
        Angle culmination;  // azimuth of the culmination
        Sense sense = Sense::Clockwise;
    };
    struct Look
    {
        Angle azimuth;  // unwrapped: it continues through north
        Angle elevation;
    };

    explicit SatellitePass(const Shape& shape);

    [[nodiscard]] Look at(Seconds fromCulmination) const;
    [[nodiscard]] Seconds halfDuration() const { return m_halfDuration; }  // from culmination to the horizon

private:
    Shape m_shape;
    double m_radius;       // of the orbit, km
    double m_angularRate;  // rad/s along it
    double m_offset;       // rad at the centre of the Earth, from the station to the track
    Seconds m_halfDuration{};
};

}  // namespace boresight::system_test
