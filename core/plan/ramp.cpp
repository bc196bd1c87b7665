// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plan/ramp.h"

#include "core/plan/corridor.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace boresight::plan {

using tracking::MotionBounds;
using tracking::MotionState;

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kRightAngle = 0.5 * std::numbers::pi;
constexpr double kAnywhere = 8.0 * std::numbers::pi;
// The bound of the error is found to this part, and to this angle.
constexpr double kPart = 0.01;
constexpr double kExact = 0.002 * kDegree;

// The least value that passes a test which all greater values pass. `most` is assumed to pass.
template <class Test>
double least(double from, double most, const Test& passes)
{
    double good = std::min(most, from + kDegree);
    double bad = from;
    while (good < most && !passes(good)) {
        bad = good;
        good = std::min(most, 2.0 * good);
    }
    while (good - bad > std::max(kExact, kPart * good)) {
        const double middle = 0.5 * (good + bad);
        (passes(middle) ? good : bad) = middle;
    }
    return good;
}

// With slack for the next steps, which have to fit inside.
double withSlack(double bound)
{
    return bound * (1.0 + kPart) + 2.0 * kExact;
}

class RampMaker
{
public:
    RampMaker(const PassPath& path, const Sides& sides, const PlanMount& mount)
        : m_path(path),
          m_part(*path.fast),
          m_sides(sides),
          m_top(std::clamp(path.top(), m_part.first, m_part.last)),
          m_elevations(mount.region.ranges().elevation),
          m_azimuth(boundsOf(mount.azimuth)),
          m_elevation(boundsOf(mount.elevation))
    {}

    [[nodiscard]] std::optional<Ramp> make() const
    {
        const double highest = m_path.points[m_top].axes.elevation.position;
        const double from = m_sides.before == m_sides.after ? 0.0 : std::max(0.0, kRightAngle - highest);
        const auto isWide = [this](double bound) { return fits({m_part.begin, m_part.end}, bound); };
        const double bound = withSlack(least(from, kRightAngle, isWide));
        Span span{m_part.begin, m_part.end};
        if (!fits(span, bound)) {
            return std::nullopt;
        }
        span.first = latestBegin(span, bound);
        span.last = earliestEnd(span, bound);
        const auto azimuth = wayThrough(azimuthGates(span, bound), azimuthEnds(span), m_azimuth);
        if (!azimuth) {
            return std::nullopt;
        }
        return withElevation(span, *azimuth, bound);
    }

private:
    struct Span
    {
        std::size_t first;
        std::size_t last;
    };

    [[nodiscard]] AxisStates imageAt(std::size_t i) const
    {
        return turned(m_path.points[i], i <= m_top ? m_sides.before : m_sides.after);
    }

    // With the best elevation, the pointing error of an azimuth that is wrong by d is asin(cos E |sin d|), and 90° - E
    // at most. So azimuths are free where the target is high enough.
    [[nodiscard]] std::vector<Gate> azimuthGates(const Span& span, double bound) const
    {
        std::vector<Gate> gates;
        gates.reserve(span.last - span.first + 1);
        for (std::size_t i = span.first; i <= span.last; ++i) {
            const AxisStates image = imageAt(i);
            const double cosine = std::cos(m_path.points[i].axes.elevation.position);
            const double width = cosine <= std::sin(bound) ? kAnywhere : std::asin(std::sin(bound) / cosine);
            gates.push_back({.seconds = m_path.points[i].seconds,
                             .low = image.azimuth.position - width,
                             .high = image.azimuth.position + width,
                             .wish = image.azimuth});
        }
        return gates;
    }

    // At the ends the axes are with the target. Where the pass begins or ends, they may be anywhere in the corridor.
    [[nodiscard]] WayEnds azimuthEnds(const Span& span) const
    {
        WayEnds ends;
        if (span.first > 0) {
            ends.first = imageAt(span.first).azimuth;
        }
        if (span.last + 1 < m_path.points.size()) {
            ends.last = imageAt(span.last).azimuth;
        }
        return ends;
    }

    [[nodiscard]] bool fits(const Span& span, double bound) const
    {
        return hasWay(azimuthGates(span, bound), azimuthEnds(span), m_azimuth);
    }

    [[nodiscard]] std::size_t latestBegin(Span span, double bound) const
    {
        std::size_t bad = m_part.first + 1;
        while (bad - span.first > 1) {
            const std::size_t middle = span.first + (bad - span.first) / 2;
            (fits({middle, span.last}, bound) ? span.first : bad) = middle;
        }
        return span.first;
    }

    [[nodiscard]] std::size_t earliestEnd(Span span, double bound) const
    {
        std::size_t bad = std::max(m_part.last, span.first + 1) - 1;
        while (span.last - bad > 1) {
            const std::size_t middle = bad + (span.last - bad) / 2;
            (middle > span.first && fits({span.first, middle}, bound) ? span.last : bad) = middle;
        }
        return span.last;
    }

    // The error is e where cos e = r cos(elevation - best), so elevations within acos(cos e / r) of the best are good.
    struct BestElevation
    {
        double best;
        double r;
    };
    [[nodiscard]] BestElevation bestElevation(std::size_t i, double azimuth) const
    {
        const AxisStates& target = m_path.points[i].axes;
        const double up = std::sin(target.elevation.position);
        const double along = std::cos(target.elevation.position) * std::cos(azimuth - target.azimuth.position);
        return {.best = std::atan2(up, along), .r = std::hypot(up, along)};
    }

    [[nodiscard]] double clampedElevation(double elevation) const
    {
        return m_elevations.clamped(Angle::fromRadians(elevation)).radians();
    }

    [[nodiscard]] std::optional<std::vector<Gate>> elevationGates(const std::vector<double>& azimuths,
                                                                  double bound) const
    {
        std::vector<Gate> gates;
        gates.reserve(azimuths.size());
        for (std::size_t i = 0; i < azimuths.size(); ++i) {
            const BestElevation here = bestElevation(m_part.begin + i, azimuths[i]);
            const double cosine = std::cos(bound) / here.r;
            const double width = std::acos(std::clamp(cosine, -1.0, 1.0));
            const double low = std::max(here.best - width, m_elevations.min.radians());
            const double high = std::min(here.best + width, m_elevations.max.radians());
            if (cosine > 1.0 || low > high) {
                return std::nullopt;
            }
            gates.push_back({.seconds = m_path.points[m_part.begin + i].seconds,
                             .low = low,
                             .high = high,
                             .wish = {std::clamp(here.best, low, high), 0.0}});
        }
        for (std::size_t i = 0; i < gates.size(); ++i) {
            const Gate& from = gates[i > 0 ? i - 1 : 0];
            const Gate& to = gates[std::min(i + 1, gates.size() - 1)];
            gates[i].wish.rate = (to.wish.position - from.wish.position) / (to.seconds - from.seconds);
        }
        return gates;
    }

    [[nodiscard]] WayEnds elevationEnds() const
    {
        const auto stateAt = [this](std::size_t i) {
            const MotionState state = imageAt(i).elevation;
            const double inside = clampedElevation(state.position);
            return MotionState{.position = inside, .rate = inside == state.position ? state.rate : 0.0};
        };
        WayEnds ends;
        if (m_part.begin > 0) {
            ends.first = stateAt(m_part.begin);
        }
        if (m_part.end + 1 < m_path.points.size()) {
            ends.last = stateAt(m_part.end);
        }
        return ends;
    }

    [[nodiscard]] std::optional<Ramp> withElevation(const Span& span, const std::vector<MotionState>& azimuth,
                                                    double bound) const
    {
        Ramp ramp{.begin = m_part.begin, .leaves = span.first, .returns = span.last};
        std::vector<double> azimuths;
        for (std::size_t i = m_part.begin; i <= m_part.end; ++i) {
            const bool isInside = i >= span.first && i <= span.last;
            ramp.states.push_back(imageAt(i));
            if (isInside) {
                ramp.states.back().azimuth = azimuth[i - span.first];
            }
            azimuths.push_back(ramp.states.back().azimuth.position);
        }
        const WayEnds ends = elevationEnds();
        const auto passes = [&](double wanted) {
            const auto gates = elevationGates(azimuths, wanted);
            return gates && hasWay(*gates, ends, m_elevation);
        };
        const double wide = withSlack(bound);
        const double enough = passes(wide) ? wide : withSlack(least(wide, 2.0 * kRightAngle, passes));
        const auto gates = elevationGates(azimuths, enough);
        const auto elevation = gates ? wayThrough(*gates, ends, m_elevation) : std::nullopt;
        if (!elevation) {
            return std::nullopt;
        }
        for (std::size_t i = 0; i < elevation->size(); ++i) {
            ramp.states[i].elevation = (*elevation)[i];
        }
        return ramp;
    }

    const PassPath& m_path;
    FastPart m_part;
    Sides m_sides;
    std::size_t m_top;
    TravelRange m_elevations;
    MotionBounds m_azimuth;
    MotionBounds m_elevation;
};

}  // namespace

std::optional<Ramp> bestRamp(const PassPath& path, const Sides& sides, const PlanMount& mount)
{
    return path.fast && path.fast->end > path.fast->begin ? RampMaker(path, sides, mount).make() : std::nullopt;
}

}  // namespace boresight::plan
