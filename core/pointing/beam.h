// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/quantity.h"

#include <optional>

// The main lobe of an antenna, as far as its half-power width describes it. Pure.
namespace boresight::pointing {

// Half-power beam width of a round dish: 70° λ/D, for a feed that lights the rim 10 dB less than the middle (Stutzman
// and Thiele, Antenna Theory and Design). `diameter` in m, `frequency` in Hz, both above zero.
[[nodiscard]] Angle beamWidthOfDish(double diameter, double frequency);

// Half-power beam width of an antenna of this gain (dBi) whose beam is as wide as it is high: θ² = 26,000 / G (the same
// book). At most 180°.
[[nodiscard]] Angle beamWidthOfGain(double gain);

// How much weaker a signal is `off` the middle of the beam, dB: 12 (off/width)². Empty beyond one beam width, where the
// main lobe ends.
[[nodiscard]] std::optional<double> pointingLoss(Angle off, Angle beamWidth);

}  // namespace boresight::pointing
