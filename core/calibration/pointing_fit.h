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

// The pointing model that points of known direction (Sun, Moon, a peak of power) speak for: a proposal, with all that
// is needed to believe it or not. Pure.
//
// One point gives the offset of azimuth, two that of elevation too. From three on every other term may move, but only
// within what was known of it before, and only if the points ask for it: the set of terms is taken that points and
// knowledge together make most probable (Bayes factors, by Laplace's approximation, exact for a model as linear as
// this). METHOD.md tells more, and what can be expected of points that all lie on the arc of the Sun.
namespace boresight::calibration {

enum class TermState
{
    Off,    // stays as it is in force, or as it was measured: the points do not ask for another value, or are too few
    Held,   // moves, but what was known counts as much as the points, which are few
    Fitted  // the points determine it
};

struct FittedTerm
{
    Estimate estimate;  // its sigma reckons with all the other terms as uncertain as they are, also those that are off
    TermState state = TermState::Off;
    QString why;  // of what is not fitted: a clause for the operator
};

struct FittedPoint
{
    SkyOffset before;  // by the model that was in force
    SkyOffset after;
    std::optional<SkyOffset> leftOut;  // by a fit without this point, to first order; nothing if too few are left
};

struct PointingFit
{
    pointing::PointingTerms terms;
    std::array<FittedTerm, kTerms> fitted;
    double chiSquare = 0.0;
    double degreesOfFreedom = 0.0;  // what knowledge determines does not count against the points
    double noiseScale = 1.0;        // by which the points scatter more than their sigmas say; the sigmas reckon with it
    Angle rmsBefore;                // on the sky
    Angle rmsAfter;
    std::optional<Angle> rmsLeftOut;
    std::vector<FittedPoint> points;  // of all that were given, the ones left out by the operator too
    std::vector<QString> hints;

    [[nodiscard]] const FittedTerm& of(Term term) const { return fitted[indexOf(term)]; }
    [[nodiscard]] int count(TermState state) const;
};

// `before`: the model in force; what the points do not ask for stays as it is there, unless `known` says more of it
// than the usual. With one or two points all else of it stays. `known` is what is believed without the points; to take
// it about the model in force again and again would count the same points twice. Refused with the reason.
[[nodiscard]] Result<PointingFit> fitPointing(std::span<const CalibrationPoint> points,
                                              const pointing::PointingTerms& before,
                                              const TermKnowledge& known = TermKnowledge::usual());

// Whether points that leave a term this uncertain have told it: else what was known before counts as much as they do.
[[nodiscard]] bool toldByPoints(Angle sigma, const std::optional<Estimate>& before);

// From how many points on a term counts as fitted.
[[nodiscard]] std::size_t fewestPoints(Term term);

}  // namespace boresight::calibration
