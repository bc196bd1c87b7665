// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/quantity.h"

#include <cstdint>

namespace boresight {

// How far a sensor on the antenna saw the azimuth turn. Plain value.
struct SensorCourse
{
    std::uint64_t unbroken = 0;  // two values with the same number: the sensor was tracked without a gap in between
    Angle azimuth;               // of the beam, true; 370° is not 10°

    bool operator==(const SensorCourse&) const = default;
};

}  // namespace boresight
