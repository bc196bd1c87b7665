// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/pointing_solver.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

// Chooses the terms of the pointing model that the points require. A step of fitPointing(); pure.
namespace boresight::calibration {

struct TermChoice
{
    TermSet set{};  // the terms that move
    pointing::PointingTerms terms;
    std::array<Angle, kTerms> sigmas;               // with all terms uncertain
    std::vector<std::optional<SkyOffset>> leftOut;  // of each point, by a fit without it
    // For each point: the probability that a good point is this far from where the other points expect it. 1 if there
    // are too few points.
    std::vector<double> chances;
    double chiSquare = 0.0;
    double degreesOfFreedom = 0.0;
    double noiseScale = 1.0;
};

// Refused with the reason if the points do not determine the azimuth offset, or if no model fits them.
[[nodiscard]] Result<TermChoice> chooseTerms(std::span<const CalibrationPoint> points,
                                             const pointing::PointingTerms& before, const TermKnowledge& known);

}  // namespace boresight::calibration
