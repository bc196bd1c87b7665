// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/calibration/pointing_solver.h"

#include <QString>

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

// Fits the pointing model to points of known direction (Sun, Moon, a peak of power). The result is a proposal with
// everything that is needed to judge it. Pure.
//
// One point gives the offset of azimuth, two also that of elevation. From three points on, every other term may move,
// but only within its known error and only if the points require it. The fit takes the set of terms that points and
// knowledge together make most probable (Bayes factors, by Laplace's approximation, exact for a model as linear as
// this). METHOD.md explains more, and what to expect of points that all lie on the arc of the Sun.
namespace boresight::calibration {

enum class TermState
{
    Off,    // keeps its value in force or its measured value: the points do not require another one, or are too few
    Held,   // moves, but the earlier knowledge counts as much as the points, which are few
    Fitted  // the points determine it
};

struct FittedTerm
{
    Estimate estimate;  // the sigma includes the uncertainty of all other terms, also of those that are off
    TermState state = TermState::Off;
    QString why;  // why it is not fitted: a clause for the operator
};

struct FittedPoint
{
    SkyOffset before;  // by the model that was in force
    SkyOffset after;
    std::optional<SkyOffset> leftOut;  // by a fit without this point, to first order; empty if too few are left
};

struct PointingFit
{
    pointing::PointingTerms terms;
    std::array<FittedTerm, kTerms> fitted;
    double chiSquare = 0.0;
    double degreesOfFreedom = 0.0;  // an unknown that earlier knowledge determines does not reduce it
    double noiseScale = 1.0;        // scatter of the points divided by their given sigmas; the results include it
    Angle rmsBefore;                // on the sky
    Angle rmsAfter;
    std::optional<Angle> rmsLeftOut;
    std::vector<FittedPoint> points;  // of all given points, including those left out by the operator
    std::vector<QString> hints;

    [[nodiscard]] const FittedTerm& of(Term term) const { return fitted[indexOf(term)]; }
    [[nodiscard]] int count(TermState state) const;
};

// `before`: the model in force. A term that the points do not require keeps its value there, unless `known` has a
// better one than usual. One or two points leave all other terms unchanged. `known`: what is known without the points.
// It must not come from a fit of the same points, which would then count twice. Refused with the reason.
[[nodiscard]] Result<PointingFit> fitPointing(std::span<const CalibrationPoint> points,
                                              const pointing::PointingTerms& before,
                                              const TermKnowledge& known = TermKnowledge::usual());

// True: the points determine a term with this sigma. False: the earlier knowledge counts as much as the points.
[[nodiscard]] bool toldByPoints(Angle sigma, const std::optional<Estimate>& before);

// The number of points from which a term counts as fitted.
[[nodiscard]] std::size_t fewestPoints(Term term);

}  // namespace boresight::calibration
