// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/path_choice.h"

#include <algorithm>
#include <cmath>

namespace boresight::tracking {

namespace {

struct Kind
{
    Shape shape;
    std::size_t fewest;  // points
    std::size_t most;
};

// METHOD.md gives the measurements.
constexpr std::array<Kind, 4> kKinds{
    {{Shape::Straight, 4, 8}, {Shape::Bent, 6, 8}, {Shape::Bent, 9, 14}, {Shape::Bent, 15, PathChoice::kMostPoints}}};

constexpr Seconds kMostApart{4.0};  // between the points of a bent path, on average
constexpr double kForgets = 0.05;   // of the error, with each point
constexpr double kOutlier = 4.0;    // times its root mean square error
constexpr double kMiss = 0.3 * std::numbers::pi / 180.0;
constexpr int kFewestJudged = 4;  // points, before a path is chosen by its error

SpaceVector unit(const SpaceVector& vector)
{
    return advanced({}, vector, 1.0 / distance(vector, {}));
}

// Then they say too little about a bend.
bool areSparse(std::span<const Point> points)
{
    return points.back().time - points.front().time > kMostApart * static_cast<double>(points.size() - 1);
}

}  // namespace

void PathChoice::clear()
{
    *this = {};
}

std::optional<double> PathChoice::foretold() const
{
    const Candidate& used = m_paths[m_best];
    return used.path && used.judged >= kFewestJudged ? std::optional(std::sqrt(used.error)) : std::nullopt;
}

void PathChoice::fit(std::span<const Point> points)
{
    m_last = points.back().time;
    for (std::size_t i = 0; i < kKinds.size(); ++i) {
        const auto& [shape, fewest, most] = kKinds[i];
        const auto latest = points.last(std::min(most, points.size()));
        m_paths[i].path = latest.size() < fewest || (shape == Shape::Bent && areSparse(latest))
                              ? std::nullopt
                              : std::optional(fittedPath(latest, shape));
    }
    m_best = 0;
    for (std::size_t i = 1; i < m_paths.size(); ++i) {
        if (m_paths[i].path && m_paths[i].judged >= kFewestJudged && m_paths[i].error < m_paths[m_best].error) {
            m_best = i;
        }
    }
}

void PathChoice::judge(const Point& next)
{
    const double time = Seconds(next.time - m_last).count();
    const auto missOf = [&](const Candidate& one) { return distance(unit(one.path->at(time)), next.direction); };
    if (const Candidate& used = m_paths[m_best]; used.path && used.judged >= kFewestJudged) {
        const double off = missOf(used);
        const bool isMissed = off > kMiss && off > kOutlier * std::sqrt(used.error);
        m_misses = isMissed ? m_misses + 1 : 0;
    }
    if (m_misses > 0) {
        return;  // it says nothing about the paths
    }
    for (Candidate& one : m_paths) {
        if (one.path) {
            const double off = missOf(one);
            one.error = one.judged == 0 ? off * off : std::lerp(one.error, off * off, kForgets);
            ++one.judged;
        }
    }
}

}  // namespace boresight::tracking
