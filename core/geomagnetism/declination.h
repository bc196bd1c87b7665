// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/units/quantity.h"

#include <QString>

#include <optional>

// A compass shows magnetic north; declination is what must be added to its heading to count from true north. The
// orientation sensor may have added one already, compiled into its firmware: here it is decided who applies it, once
// and never twice, and said in words with the numbers. Pure.
namespace boresight::geomagnetism {

// What the published firmware of the sensor adds to its heading: the declination of Berlin.
inline constexpr Angle kDeclinationInFirmware = Angle::fromDegrees(5.07);

enum class DeclinationBy
{
    Sensor,     // its heading is taken as one from true north
    Boresight,  // what the sensor has added is taken away, and the declination of the place is added
    None        // the heading stays as it comes; whatever is left is part of the azimuth offset
};

enum class DeclinationOrigin
{
    Typed,
    Model  // the World Magnetic Model at the site and the date
};

struct Declination
{
    DeclinationBy by = DeclinationBy::Sensor;
    Angle inSensor = kDeclinationInFirmware;  // 0 for a firmware without
    std::optional<Angle> here;                // of the place, as far as it is known
    DeclinationOrigin origin = DeclinationOrigin::Typed;

    bool operator==(const Declination&) const = default;
};

// What to add to north in place of what the sensor has added: east is positive, whichever way the sensor counts
// (orientation::Correction does that). Refused where Boresight shall apply a value that is not known.
[[nodiscard]] Result<Angle> declinationCorrection(const Declination& declination);

// What is done, with the numbers; and what is doubtful about it, or empty: a declination that was not compiled in for
// this place, or one that nobody applies.
[[nodiscard]] QString describe(const Declination& declination);
[[nodiscard]] QString doubt(const Declination& declination);

}  // namespace boresight::geomagnetism
