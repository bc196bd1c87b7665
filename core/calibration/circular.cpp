// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/circular.h"

#include <cmath>

namespace boresight::calibration {

CircularMean circularMean(std::span<const Angle> angles)
{
    double east = 0.0;
    double north = 0.0;
    for (const Angle angle : angles) {
        east += std::sin(angle.radians());
        north += std::cos(angle.radians());
    }
    const double count = angles.empty() ? 1.0 : static_cast<double>(angles.size());
    return {.direction = Angle::fromRadians(std::atan2(east, north)).wrapped360(),
            .length = std::hypot(east, north) / count};
}

}  // namespace boresight::calibration
