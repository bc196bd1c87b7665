// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/units/quantity.h"

#include <QString>

#include <optional>

// A compass shows magnetic north. The declination must be added to its heading to count from true north. The
// orientation sensor may have added one already, which is compiled into its firmware. This code decides who adds the
// declination, so that it is added exactly once, and describes the decision with the numbers. Pure.
namespace boresight::geomagnetism {

// The published firmware of the sensor adds this declination, which is that of Berlin.
inline constexpr Angle kDeclinationInFirmware = Angle::fromDegrees(5.07);

enum class DeclinationBy
{
    Sensor,     // the sensor's heading is taken as relative to true north
    Boresight,  // the declination in the sensor is subtracted, and that of the place is added
    None        // the heading stays as sent; the rest is part of the azimuth offset
};

enum class DeclinationOrigin
{
    Typed,
    Model  // the World Magnetic Model at the site and the date
};

struct Declination
{
    DeclinationBy by = DeclinationBy::Sensor;
    Angle inSensor = kDeclinationInFirmware;  // 0 for a firmware that adds none
    std::optional<Angle> here;                // of the place; empty: unknown
    DeclinationOrigin origin = DeclinationOrigin::Typed;

    bool operator==(const Declination&) const = default;
};

// The declination to add to the heading in place of the sensor's. East is positive, whatever the sense of the sensor
// (orientation::Correction handles that). Refused if Boresight must add a value that is unknown.
[[nodiscard]] Result<Angle> declinationCorrection(const Declination& declination);

// describe(): what is done, with the numbers. doubt(): why it may be wrong, for example a declination that is not for
// this place, or that nobody adds. Empty: no doubt.
[[nodiscard]] QString describe(const Declination& declination);
[[nodiscard]] QString doubt(const Declination& declination);

}  // namespace boresight::geomagnetism
