// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/calibration/pointing_term.h"

#include <QString>

#include <array>
#include <optional>
#include <span>
#include <vector>

// Weighted least squares of the exact pointing model. Earlier knowledge adds equations. The result is the terms that
// make points and knowledge most likely together. Pure.
namespace boresight::calibration {

struct CalibrationPoint
{
    AxisPosition axes;
    SkyPointing truth;                       // of the source, as the beam sees it (with refraction)
    Angle sigma = Angle::fromDegrees(0.03);  // how well the source was centred, on the sky, in each direction
    UtcTime when;
    QString label;       // "Sun"
    bool isUsed = true;  // false: the operator left it out

    bool operator==(const CalibrationPoint&) const = default;
};

// On the sky. Across is positive clockwise; a small offset across is the error of azimuth × cos(elevation).
struct SkyOffset
{
    Angle across;
    Angle elevation;

    [[nodiscard]] Angle size() const;
    bool operator==(const SkyOffset&) const = default;
};

// The direction of the beam by the model, relative to its true direction.
[[nodiscard]] SkyOffset offsetOf(const CalibrationPoint& point, const pointing::PointingModel& model);

struct TermSolution
{
    pointing::PointingTerms terms;
    std::array<Angle, kTerms> sigmas;  // of the solved terms, with the sigmas of the points as given
    double chiSquare = 0.0;            // of the points
    double knowledge = 0.0;            // chi square of the earlier knowledge
    double logVolume = 0.0;            // of the remaining uncertainty: ½ log det of the covariance
    // Offset of each point from a fit without it, to first order. Empty if the other points do not determine the terms.
    std::vector<std::optional<SkyOffset>> leftOut;
    // The square of `leftOut` in sigmas of the point and of the prediction together. 0 if `leftOut` is empty.
    std::vector<double> strangeness;
};

using TermSet = std::array<bool, kTerms>;

// Solves for the terms of the set. All other terms stay as they are in `start`. Refused if points and knowledge
// together do not determine the terms, or if the iteration does not converge.
[[nodiscard]] Result<TermSolution> solveTerms(std::span<const CalibrationPoint> points,
                                              const pointing::PointingTerms& start, const TermSet& set,
                                              const TermKnowledge& known);

}  // namespace boresight::calibration
