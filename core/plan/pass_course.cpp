// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plan/pass_course.h"

#include "core/plan/plan_drive.h"
#include "core/units/angle_between.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <tuple>
#include <utility>

namespace boresight::plan {

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

PlanWay wayOf(const Sides& sides)
{
    const int apart = std::abs(sides.after - sides.before);
    return apart == 1              ? PlanWay::ThroughTheZenith
           : apart > 1             ? PlanWay::OtherWayRound
           : sides.before % 2 == 0 ? PlanWay::Direct
                                   : PlanWay::OverTheTop;
}

AxisStates onWrap(AxisStates states, int wrap)
{
    states.azimuth.position += wrap * kTurn;
    return states;
}

// A path beyond the ranges means the end of the ranges, where the axes stand.
AxisStates clamped(AxisStates states, const pointing::AxisBox& ranges)
{
    const auto clampTo = [](tracking::MotionState& state, const TravelRange& range) {
        const double inside = range.clamped(Angle::fromRadians(state.position)).radians();
        if (std::abs(inside - state.position) > 1e-12) {
            state = {inside, 0.0};
        }
    };
    clampTo(states.azimuth, ranges.azimuth);
    clampTo(states.elevation, ranges.elevation);
    return states;
}

// The part of the path from the first point that is not hidden to the last one. All of it, if all is hidden.
std::pair<std::size_t, std::size_t> seenPart(const PassPath& path)
{
    std::size_t first = 0;
    std::size_t last = path.points.size() - 1;
    while (first < last && path.points[first].isHidden) {
        ++first;
    }
    while (last > first && path.points[last].isHidden) {
        --last;
    }
    return first < last ? std::pair(first, last) : std::pair(std::size_t{0}, path.points.size() - 1);
}

std::pair<double, double> sweptBy(const PassPath& path, const Course& course)
{
    const auto [first, last] = seenPart(path);
    double low = course.states[first].azimuth.position;
    double high = low;
    for (std::size_t i = first; i <= last; ++i) {
        low = std::min(low, course.states[i].azimuth.position);
        high = std::max(high, course.states[i].azimuth.position);
    }
    return {low, high};
}

PlanVariant finished(const PlanFrame& frame, PlanWay way, std::vector<AxisStates> wanted)
{
    const PassPath& path = frame.path;
    const pointing::AxisBox& ranges = frame.mount.region.ranges();
    for (AxisStates& states : wanted) {
        states = clamped(states, ranges);
    }
    const std::vector<AxisStates> motion =
        canFollow(path, wanted, frame.mount) ? std::move(wanted) : driven(path, wanted, frame.mount);
    PlanVariant variant{.way = way, .margin = ranges.azimuth.max - ranges.azimuth.min};
    for (std::size_t i = 0; i < motion.size(); ++i) {
        const PathPoint& point = path.points[i];
        const AxisPosition place = motion[i].place();
        variant.moments.push_back({.utc = point.utc,
                                   .target = point.direction,
                                   .axes = place,
                                   .rates = {AngularRate::fromRadians(motion[i].azimuth.rate),
                                             AngularRate::fromRadians(motion[i].elevation.rate)},
                                   .error = angleBetween(frame.mount.pointing.toSky(place), point.direction),
                                   .isHidden = point.isHidden});
        variant.margin =
            std::min({variant.margin, place.azimuth - ranges.azimuth.min, ranges.azimuth.max - place.azimuth});
    }
    variant.forecast = forecastOf(variant.moments, frame.bound, frame.mount.beamWidth);
    const auto slew = [](Angle from, Angle to, const tracking::MotionLimits& limits) {
        return Seconds(tracking::restTime({from.radians(), 0.0}, to.radians(), boundsOf(limits)));
    };
    const AxisPosition start = variant.start();
    variant.toStart = std::max(slew(frame.now.azimuth, start.azimuth, frame.mount.azimuth),
                               slew(frame.now.elevation, start.elevation, frame.mount.elevation));
    return variant;
}

PlanVariant waiting(const PlanFrame& frame, const Course& course, int wrap)
{
    PlanVariant variant = variantOf(frame, course, wrap);
    variant.way = PlanWay::WaitsAtTheEnd;
    return variant;
}

// An unwrap from one point of the path to another.
struct Unwrap
{
    std::size_t from = 0;
    std::size_t to = 0;
    double lost = 0.0;       // s that are not hidden
    double elevation = 0.0;  // mean
};

// The best moment to change from one wrap to another.
class UnwrapSearch
{
public:
    UnwrapSearch(const PlanFrame& frame, const Course& course, int wrap, int nextWrap)
        : m_frame(frame), m_course(course), m_wrap(wrap), m_nextWrap(nextWrap)
    {
        for (const PathPoint& point : frame.path.points) {
            const double step = m_seen.empty() ? 0.0 : point.seconds - frame.path.points[m_seen.size() - 1].seconds;
            m_seen.push_back(m_seen.empty() ? 0.0 : m_seen.back() + (point.isHidden ? 0.0 : step));
        }
    }

    [[nodiscard]] std::optional<Unwrap> best() const
    {
        const std::size_t count = m_course.states.size();
        std::size_t roomFrom = count;  // from here on the next wrap has room
        while (roomFrom > 0 && hasRoom(roomFrom - 1, m_nextWrap)) {
            --roomFrom;
        }
        std::optional<Unwrap> found;
        std::size_t to = std::max<std::size_t>(roomFrom, 1);
        for (std::size_t from = 0; from + 1 < count && hasRoom(from, m_wrap); ++from) {
            to = std::max(to, from + 1);
            while (to < count && !arrives(from, to)) {
                ++to;
            }
            if (to == count) {
                break;
            }
            const Unwrap here{.from = from,
                              .to = to,
                              .lost = m_seen[to] - m_seen[from],
                              .elevation = 0.5 * (elevation(from) + elevation(to))};
            constexpr double kSameTime = 0.5;
            const auto rank = [&](const Unwrap& one) {
                return std::tuple(std::round(one.lost / kSameTime), one.elevation);
            };
            if (!found || rank(here) < rank(*found)) {
                found = here;
            }
        }
        return found;
    }

private:
    [[nodiscard]] double azimuth(std::size_t i, int wrap) const
    {
        return m_course.states[i].azimuth.position + wrap * kTurn;
    }
    [[nodiscard]] double elevation(std::size_t i) const { return m_frame.path.points[i].axes.elevation.position; }

    [[nodiscard]] bool hasRoom(std::size_t i, int wrap) const
    {
        const TravelRange& range = m_frame.mount.region.ranges().azimuth;
        return m_frame.path.points[i].isHidden || range.contains(Angle::fromRadians(azimuth(i, wrap)));
    }

    [[nodiscard]] bool arrives(std::size_t from, std::size_t to) const
    {
        const tracking::MotionState begin{azimuth(from, m_wrap), m_course.states[from].azimuth.rate};
        return m_frame.path.points[to].seconds - m_frame.path.points[from].seconds >=
               tracking::restTime(begin, azimuth(to, m_nextWrap), boundsOf(m_frame.mount.azimuth));
    }

    const PlanFrame& m_frame;
    const Course& m_course;
    int m_wrap;
    int m_nextWrap;
    std::vector<double> m_seen;  // s that are not hidden, from the first point to each
};

std::optional<PlanSpan> rampOf(const PassPath& path, const Course& course)
{
    return course.ramp
               ? std::optional(PlanSpan{path.points[course.ramp->leaves].utc, path.points[course.ramp->returns].utc})
               : std::nullopt;
}

// When the mount is with the target again: later than the azimuth alone needs if the way leads around a keep-out.
UtcTime arrival(const PlanVariant& variant, std::size_t earliest)
{
    constexpr Angle kWith = Angle::fromDegrees(0.2);
    const auto begin = variant.moments.begin() + static_cast<std::ptrdiff_t>(earliest);
    const auto with = std::find_if(begin, variant.moments.end(), [&](const PlannedMoment& moment) {
        return moment.isHidden || moment.error < kWith;
    });
    return with == variant.moments.end() ? begin->utc : with->utc;
}

std::optional<PlanVariant> unwrapping(const PlanFrame& frame, const Course& course, int wrap, int nextWrap)
{
    const auto best = UnwrapSearch(frame, course, wrap, nextWrap).best();
    if (!best) {
        return std::nullopt;
    }
    std::vector<AxisStates> wanted;
    for (std::size_t i = 0; i < course.states.size(); ++i) {
        wanted.push_back(onWrap(course.states[i], i <= best->from ? wrap : nextWrap));
    }
    PlanVariant variant = finished(frame, PlanWay::Unwraps, std::move(wanted));
    variant.unwrap = PlanSpan{frame.path.points[best->from].utc, arrival(variant, best->to)};
    variant.unwrapsTo = onWrap(course.states[best->to], nextWrap).place().azimuth;
    variant.ramp = rampOf(frame.path, course);
    return variant;
}

}  // namespace

std::optional<Course> courseOf(const PassPath& path, const Sides& sides, const PlanMount& mount)
{
    Course course{.way = wayOf(sides)};
    const std::size_t top = path.top();
    const TravelRange& elevations = mount.region.ranges().elevation;
    for (std::size_t i = 0; i < path.points.size(); ++i) {
        const int halfTurns = i <= top ? sides.before : sides.after;
        course.states.push_back(turned(path.points[i], halfTurns));
        const AxisPosition place = course.states.back().place();
        if (halfTurns % 2 != 0 && !path.points[i].isHidden &&
            !elevations.contains(onTheRim(place, elevations).elevation)) {
            return std::nullopt;
        }
    }
    if (path.fast) {
        course.ramp = bestRamp(path, sides, mount);
        if (!course.ramp) {
            return std::nullopt;
        }
        std::ranges::copy(course.ramp->states, course.states.begin() + static_cast<std::ptrdiff_t>(course.ramp->begin));
    }
    return path.fast || sides.before == sides.after ? std::optional(std::move(course)) : std::nullopt;
}

tracking::WholeTurns wrapsOf(const PassPath& path, const Course& course, const PlanMount& mount)
{
    constexpr double kRounding = 1e-9;
    const auto [low, high] = sweptBy(path, course);
    const TravelRange& range = mount.region.ranges().azimuth;
    return {.first = static_cast<int>(std::ceil((range.min.radians() - low) / kTurn - kRounding)),
            .last = static_cast<int>(std::floor((range.max.radians() - high) / kTurn + kRounding))};
}

PlanVariant variantOf(const PlanFrame& frame, const Course& course, int wrap)
{
    std::vector<AxisStates> wanted;
    for (const AxisStates& states : course.states) {
        wanted.push_back(onWrap(states, wrap));
    }
    PlanVariant variant = finished(frame, course.way, std::move(wanted));
    variant.ramp = rampOf(frame.path, course);
    return variant;
}

std::vector<PlanVariant> splitsOf(const PlanFrame& frame, const Course& course)
{
    const auto [low, high] = sweptBy(frame.path, course);
    const TravelRange& range = frame.mount.region.ranges().azimuth;
    const int first = static_cast<int>(std::ceil((range.min.radians() - high) / kTurn));
    const int last = static_cast<int>(std::floor((range.max.radians() - low) / kTurn));
    std::vector<PlanVariant> found;
    for (int wrap = first; wrap <= last; ++wrap) {
        found.push_back(waiting(frame, course, wrap));
        for (const int nextWrap : {wrap - 1, wrap + 1}) {
            if (auto variant = unwrapping(frame, course, wrap, nextWrap)) {
                found.push_back(std::move(*variant));
            }
        }
    }
    return found;
}

}  // namespace boresight::plan
