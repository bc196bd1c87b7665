// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/term_choice.h"

#include "core/base/text.h"
#include "core/calibration/fit_words.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace boresight::calibration {
namespace {

using pointing::PointingModel;
using pointing::PointingTerms;

constexpr std::size_t kPointsForElevation = 2;
constexpr std::size_t kPointsForMore = 3;
constexpr double kLeastWeight = 1e-4;  // of cos² of elevation: at the zenith azimuth is meaningless

// Terms that are turned on and off together: a tilt has two parts.
constexpr std::array<TermSet, 4> kGroups = {{{false, false, true, true, false, false, false},
                                             {false, false, false, false, true, false, false},
                                             {false, false, false, false, false, true, false},
                                             {false, false, false, false, false, false, true}}};

TermSet basicSet(std::size_t points)
{
    return {true, points >= kPointsForElevation, false, false, false, false, false};
}

TermSet withGroups(TermSet set, unsigned groups)
{
    for (std::size_t group = 0; group < kGroups.size(); ++group) {
        for (std::size_t term = 0; term < kTerms; ++term) {
            set[term] = set[term] || ((groups >> group & 1U) != 0 && kGroups[group][term]);
        }
    }
    return set;
}

constexpr unsigned kAllGroups = (1U << kGroups.size()) - 1;

// One or two points are not enough to move a term away from its value in force.
TermKnowledge aboutForce(std::size_t points, const PointingTerms& before, const TermKnowledge& known)
{
    TermKnowledge result = known;
    for (const Term term : kAllTerms) {
        if (auto& estimate = result.of(term); estimate && points < kPointsForMore) {
            estimate->value = valueOf(before, term);
        }
    }
    return result;
}

// A term that is off keeps its value in force, unless `known` has a better one than usual (a tilt from a swing). The
// azimuth offset starts near its solution.
Result<PointingTerms> startFrom(std::span<const CalibrationPoint> points, const PointingTerms& before,
                                const TermKnowledge& known)
{
    static const TermKnowledge usual = TermKnowledge::usual();
    PointingTerms start = before;
    for (const Term term : kAllTerms) {
        if (const auto& estimate = known.of(term); estimate && estimate != usual.of(term)) {
            valueOf(start, term) = estimate->value;
        }
    }
    const PointingModel model(start);
    double east = 0.0;
    double north = 0.0;
    double weights = 0.0;
    for (const CalibrationPoint& point : points) {
        const SkyPointing truth = pointing::upright(point.truth);
        const double shrink = std::cos(truth.elevation.radians());
        const double away = (truth.azimuth - pointing::upright(model.toSky(point.axes)).azimuth).radians();
        east += shrink * shrink * std::sin(away);
        north += shrink * shrink * std::cos(away);
        weights += shrink * shrink;
    }
    if (weights < kLeastWeight) {
        return failure(ErrorCode::Refused,
                       Text::tr("The points do not determine the azimuth offset. Take a point away from the zenith."));
    }
    start.azimuthOffset = (start.azimuthOffset + Angle::fromRadians(std::atan2(east, north))).wrapped360();
    return start;
}

// The logarithm of the probability of a set of terms, given points and knowledge. Only the part that differs between
// sets.
double evidence(const TermSolution& solution, const TermSet& set, const TermKnowledge& known)
{
    double result = -0.5 * (solution.chiSquare + solution.knowledge) + solution.logVolume;
    for (const Term term : kAllTerms) {
        if (set[indexOf(term)] && known.of(term)) {
            result -= std::log(known.of(term)->sigma.radians());
        }
    }
    return result;
}

// How many unknowns the points determine. A term whose sigma the points do not reduce counts 0.
double unknownsTold(const TermSolution& solution, const TermSet& set, const TermKnowledge& known)
{
    double told = 0.0;
    for (const Term term : kAllTerms) {
        if (set[indexOf(term)]) {
            const auto& before = known.of(term);
            const double kept = before ? solution.sigmas[indexOf(term)] / before->sigma : 0.0;
            told += 1.0 - std::min(kept * kept, 1.0);
        }
    }
    return told;
}

double noiseScaleOf(const TermSolution& solution, double free)
{
    return free >= 1.0 ? std::max(1.0, std::sqrt(solution.chiSquare / free)) : 1.0;
}

std::vector<CalibrationPoint> withNoise(std::span<const CalibrationPoint> points, double scale)
{
    std::vector<CalibrationPoint> result(points.begin(), points.end());
    for (CalibrationPoint& point : result) {
        point.sigma = point.sigma * scale;
    }
    return result;
}

// The probability of each point: the tail of the F distribution with two degrees of freedom in the numerator, against
// the scatter of the other points but at least their stated sigmas. If there are few points, each of them bends the
// whole fit, so no point is named.
std::vector<double> chancesOf(const TermSolution& solution, double free)
{
    std::vector<double> chances;
    const double freeOfOthers = free - 2.0;
    for (const double strangeness : solution.strangeness) {
        const double scatter = (solution.chiSquare - strangeness) / freeOfOthers;
        chances.push_back(freeOfOthers < 1.0 ? 1.0
                                             : std::pow(1.0 + strangeness / (std::max(scatter, 1.0) * freeOfOthers),
                                                        -freeOfOthers / 2.0));
    }
    return chances;
}

struct Candidate
{
    TermSet set{};
    TermSolution solution;
};

Result<Candidate> mostProbable(std::span<const CalibrationPoint> points, const PointingTerms& start,
                               const TermKnowledge& known)
{
    Result<Candidate> best = tl::unexpected(Error{});
    double bestEvidence = 0.0;
    const unsigned last = points.size() >= kPointsForMore ? kAllGroups : 0U;
    for (unsigned groups = 0; groups <= last; ++groups) {
        const TermSet set = withGroups(basicSet(points.size()), groups);
        const auto solution = solveTerms(points, start, set, known);
        if (!solution) {
            best = best ? best : tl::unexpected(solution.error());
            continue;
        }
        const double found = evidence(*solution, set, known);
        if (!best || found > bestEvidence) {
            best = Candidate{set, *solution};
            bestEvidence = found;
        }
    }
    return best;
}

// With few points, the terms that stay are as uncertain as before, and make the moving terms uncertain, too. Each
// moving term gets the change that results when a staying term is shifted by its sigma.
std::array<Angle, kTerms> sigmasAmidUnknown(std::span<const CalibrationPoint> points, const PointingTerms& start,
                                            const Candidate& best, const TermKnowledge& known)
{
    std::array<Angle, kTerms> sigmas = best.solution.sigmas;
    for (const Term stays : kAllTerms) {
        const auto& before = known.of(stays);
        if (best.set[indexOf(stays)] || !before) {
            continue;
        }
        PointingTerms moved = start;
        valueOf(moved, stays) += before->sigma;
        const auto solution = solveTerms(points, moved, best.set, known);
        for (const Term term : kAllTerms) {
            const PointingTerms& with = solution ? solution->terms : moved;
            sigmas[indexOf(term)] =
                hypot(sigmas[indexOf(term)], (valueOf(with, term) - valueOf(best.solution.terms, term)).wrapped180());
        }
    }
    return sigmas;
}

}  // namespace

Result<TermChoice> chooseTerms(std::span<const CalibrationPoint> points, const PointingTerms& before,
                               const TermKnowledge& given)
{
    const TermKnowledge known = aboutForce(points.size(), before, given);
    const auto start = startFrom(points, before, known);
    if (!start) {
        return tl::unexpected(start.error());
    }
    // With all terms free only noise is left. This fit gives the size of the noise.
    const TermSet all = withGroups(basicSet(kPointsForMore), kAllGroups);
    const auto whole = solveTerms(points, *start, all, known);
    if (!whole) {
        return tl::unexpected(whole.error());
    }
    const auto rows = 2.0 * static_cast<double>(points.size());
    const double free = rows - unknownsTold(*whole, all, known);
    const double scale = noiseScaleOf(*whole, free);
    const std::vector<CalibrationPoint> weighed = withNoise(points, scale);
    const auto best = mostProbable(weighed, *start, known);
    if (!best) {
        return tl::unexpected(best.error());
    }
    return TermChoice{.set = best->set,
                      .terms = best->solution.terms,
                      .sigmas = points.size() < kPointsForMore
                                    ? sigmasAmidUnknown(weighed, *start, *best, known)
                                    : solveTerms(weighed, *start, all, known).value_or(best->solution).sigmas,
                      .leftOut = best->solution.leftOut,
                      .chances = chancesOf(*whole, free),
                      .chiSquare = best->solution.chiSquare * scale * scale,
                      .degreesOfFreedom = rows - unknownsTold(best->solution, best->set, known),
                      .noiseScale = scale};
}

}  // namespace boresight::calibration
