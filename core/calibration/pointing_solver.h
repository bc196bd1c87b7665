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

// Weighted least squares of the exact pointing model, with what is known before as further equations: the terms that
// make points and knowledge most likely together. Pure.
namespace boresight::calibration {

struct CalibrationPoint
{
    AxisPosition axes;
    SkyPointing truth;                       // of the source, as the beam sees it (refraction dealt with)
    Angle sigma = Angle::fromDegrees(0.03);  // of how well the source was centred, on the sky, each way
    UtcTime when;
    QString label;       // "Sun"
    bool isUsed = true;  // the operator may leave one out

    bool operator==(const CalibrationPoint&) const = default;
};

// On the sky: across is positive clockwise and is the error of azimuth × cos(elevation) while small.
struct SkyOffset
{
    Angle across;
    Angle elevation;

    [[nodiscard]] Angle size() const;
    bool operator==(const SkyOffset&) const = default;
};

// Where the beam is by the model, seen from where it is in truth.
[[nodiscard]] SkyOffset offsetOf(const CalibrationPoint& point, const pointing::PointingModel& model);

struct TermSolution
{
    pointing::PointingTerms terms;
    std::array<Angle, kTerms> sigmas;  // of the terms solved for, at the points' own sigmas
    double chiSquare = 0.0;            // of the points
    double knowledge = 0.0;            // the same of what was known before
    double logVolume = 0.0;            // of what is left uncertain: ½ log det of the covariance
    // Where a fit without this point would see it, to first order; nothing if the others do not determine the terms.
    std::vector<std::optional<SkyOffset>> leftOut;
    // The square of that in sigmas, of the point and of what the others foresee together; 0 where there is nothing.
    std::vector<double> strangeness;
};

using TermSet = std::array<bool, kTerms>;

// Solves for the terms of the set; the others stay as they are in `start`. Refused if points and knowledge together do
// not determine them, or if it does not converge.
[[nodiscard]] Result<TermSolution> solveTerms(std::span<const CalibrationPoint> points,
                                              const pointing::PointingTerms& start, const TermSet& set,
                                              const TermKnowledge& known);

}  // namespace boresight::calibration
