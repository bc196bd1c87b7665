// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/quantity.h"

#include <cstdint>

namespace boresight {

// How a sensor on the antenna has seen the azimuth go. Plain value.
struct SensorCourse
{
    std::uint64_t unbroken = 0;  // the same number: the sensor could be followed all the time in between
    Angle azimuth;               // of the beam, true; 370° is not 10°

    bool operator==(const SensorCourse&) const = default;
};

}  // namespace boresight
