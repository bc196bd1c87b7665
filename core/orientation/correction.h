// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/orientation/orientation.h"
#include "core/units/sky.h"

// From what the sensor says to a true direction: how it is mounted, and whose declination counts. Pure.
//
// The firmware adds a declination of its own, which is compiled in, to its heading (5.07°, that of Berlin). So that
// none is applied twice, it is first taken off, and then exactly one is added: the same again, that of the site, or
// none. This matters where the sensor counts against the compass, and what it adds has the wrong sign.
namespace boresight::orientation {

// Which way the heading grows, seen from above: the sensor may be mounted face down.
enum class Sense
{
    Clockwise,  // with the compass
    CounterClockwise
};

enum class Declination
{
    OfSensor,  // the sensor adds the right one
    OfSite,    // Boresight adds that of the site in place of the sensor's
    None       // the heading is shown as a compass would
};

struct CorrectionSettings
{
    Sense sense = Sense::Clockwise;
    Angle azimuthOffset;    // true azimuth of the beam where the sensor looks north
    Angle elevationOffset;  // elevation of the beam where the sensor says 0°
    Declination declination = Declination::OfSensor;
    Angle ofSensor = Angle::fromDegrees(5.07);  // what the firmware adds
    Angle ofSite;                               // east positive

    bool operator==(const CorrectionSettings&) const = default;
};

class Correction
{
public:
    Correction() = default;
    explicit Correction(const CorrectionSettings& settings) : m_settings(settings) {}

    [[nodiscard]] Angle trueHeading(SensorHeading heading) const;
    [[nodiscard]] Angle elevation(Angle raw) const { return raw + m_settings.elevationOffset; }
    [[nodiscard]] SkyPointing direction(const Orientation& value) const
    {
        return {.azimuth = trueHeading(value.heading), .elevation = elevation(value.elevation)};
    }
    // That is added in the end.
    [[nodiscard]] Angle declination() const;

private:
    CorrectionSettings m_settings;
};

}  // namespace boresight::orientation
