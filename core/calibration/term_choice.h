// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/pointing_solver.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

// Which terms of the pointing model the points ask for. A step of fitPointing(); pure.
namespace boresight::calibration {

struct TermChoice
{
    TermSet set{};  // the terms that move
    pointing::PointingTerms terms;
    std::array<Angle, kTerms> sigmas;               // with all terms uncertain
    std::vector<std::optional<SkyOffset>> leftOut;  // of each point, by a fit without it
    double chiSquare = 0.0;
    double degreesOfFreedom = 0.0;
    double noiseScale = 1.0;
};

// Nothing if the points do not determine the offset of azimuth.
[[nodiscard]] std::optional<TermChoice> chooseTerms(std::span<const CalibrationPoint> points,
                                                    const pointing::PointingTerms& before, const TermKnowledge& known);

}  // namespace boresight::calibration
