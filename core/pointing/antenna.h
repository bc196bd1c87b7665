// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pointing/pointing_model.h"
#include "core/units/quantity.h"

#include <optional>
#include <string>

// One of several antennas on a mount. The pointing model of the mount is that of its main antenna. The beams of the
// others are fixed to the same boom and look past the main beam by two angles. Pure values, any thread.
namespace boresight::pointing {

inline constexpr const char* kMainAntenna = "main";

struct Antenna
{
    std::string name = kMainAntenna;
    Angle beamWidth = Angle::fromDegrees(10.0);  // half-power
    Angle across;  // from the main beam, clockwise on the sky: the azimuth has it over cos el
    Angle up;

    [[nodiscard]] bool isMain() const { return name == kMainAntenna; }
    bool operator==(const Antenna&) const = default;
};

// The terms by which the beam of this antenna points, from those of the main antenna: it is turned with both axes as
// the main beam is, so both angles add up exactly, also at the zenith. Only the sag of the boom goes by each beam's own
// elevation. Without an elevation axis what is across is an
// angle of the azimuth.
[[nodiscard]] PointingTerms termsFor(PointingTerms main, const Antenna& antenna, std::optional<Axis> missing);

// Between the beams of both.
[[nodiscard]] Angle beamDistance(const Antenna& one, const Antenna& other);

}  // namespace boresight::pointing
