// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pointing/pointing_model.h"
#include "core/units/quantity.h"

#include <optional>
#include <string>

// One of several antennas on a mount. The pointing model of the mount is that of its main antenna. The beam of another
// antenna is fixed to the same boom at two angles from the main beam. Pure values, any thread.
namespace boresight::pointing {

inline constexpr const char* kMainAntenna = "main";

struct Antenna
{
    std::string name = kMainAntenna;
    Angle beamWidth = Angle::fromDegrees(10.0);  // half-power
    Angle across;  // from the main beam, clockwise on the sky: the difference of azimuth is across / cos(elevation)
    Angle up;

    [[nodiscard]] bool isMain() const { return name == kMainAntenna; }
    bool operator==(const Antenna&) const = default;
};

// The terms of this antenna's beam, computed from the terms of the main antenna. Both beams turn with both axes, so
// both angles add exactly, also at the zenith. Only the sag of the boom depends on each beam's own elevation. Without
// an elevation axis, `across` is an angle of azimuth.
[[nodiscard]] PointingTerms termsFor(PointingTerms main, const Antenna& antenna, std::optional<Axis> missing);

// The angle between both beams.
[[nodiscard]] Angle beamDistance(const Antenna& one, const Antenna& other);

}  // namespace boresight::pointing
