// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/quantity.h"

#include <optional>

// The main lobe of an antenna, described by its half-power width. Pure.
namespace boresight::pointing {

// Half-power beam width of a round dish: 70° λ/D, for a feed that illuminates the rim 10 dB less than the centre
// (Stutzman and Thiele, Antenna Theory and Design). `diameter` in m, `frequency` in Hz, both above zero.
[[nodiscard]] Angle beamWidthOfDish(double diameter, double frequency);

// Half-power beam width of an antenna with this gain (dBi) and a beam of equal width and height: θ² = 26,000 / G (the
// same book). At most 180°.
[[nodiscard]] Angle beamWidthOfGain(double gain);

// Loss in dB of a signal at the angle `off` from the centre of the beam: 12 (off/width)². Empty beyond one beam width,
// where the main lobe ends.
[[nodiscard]] std::optional<double> pointingLoss(Angle off, Angle beamWidth);

}  // namespace boresight::pointing
