// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plan/pass_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace boresight::plan {

namespace {

constexpr double kPi = std::numbers::pi;
// Time between two points, s.
constexpr double kLongestStep = 20.0;
constexpr double kUsualStep = 0.5;
constexpr double kShortestStep = 0.05;
constexpr double kUsualPoints = 1200.0;
constexpr double kRampPoints = 4000.0;
// Two neighbours are at most this far apart in each axis, unless they are kShortestStep apart.
constexpr double kFarApart = 2.0 / 180.0 * kPi;

AxisStates statesAt(const AxisPosition& place)
{
    return {.azimuth = {place.azimuth.radians(), 0.0}, .elevation = {place.elevation.radians(), 0.0}};
}

class PathMaker
{
public:
    PathMaker(const DirectionAt& directionAt, UtcTime from, UtcTime to, const PlanMount& mount)
        : m_directionAt(directionAt), m_from(from), m_length(Seconds(to - from).count()), m_mount(mount)
    {}

    PassPath make()
    {
        const double step = std::clamp(m_length / kUsualPoints, kUsualStep, kLongestStep);
        addUntil(m_length, step, true);
        const auto fast = fastTimes();
        if (fast) {
            makeFiner(*fast, step);
        }
        addRates();
        for (PathPoint& point : m_path.points) {
            point.isHidden = hides(point);
        }
        return std::move(m_path);
    }

private:
    struct Times
    {
        double from;
        double to;
    };

    bool add(double seconds)
    {
        const UtcTime utc = m_from + std::chrono::round<UtcTime::duration>(Seconds(seconds));
        const auto direction = m_directionAt(utc);
        if (!direction) {
            return false;
        }
        AxisPosition axes = m_mount.pointing.toAxes(*direction).axes;
        auto& points = m_path.points;
        if (!points.empty()) {
            axes.azimuth = axes.azimuth.nearestTo(Angle::fromRadians(points.back().axes.azimuth.position));
        }
        AxisPosition over =
            m_mount.pointing.toAxes({direction->azimuth + 180_deg, 180_deg - direction->elevation}).axes;
        over.azimuth = over.azimuth.nearestTo(axes.azimuth + 180_deg);
        points.push_back({.utc = utc,
                          .seconds = seconds,
                          .direction = *direction,
                          .axes = statesAt(axes),
                          .overTheTop = statesAt(over)});
        return true;
    }

    // Adds the points after the last one, up to and including `until`.
    void addUntil(double until, double step, bool refines)
    {
        double now = m_path.points.empty() ? -step : m_path.points.back().seconds;
        while (now < until) {
            const double next = until - now < 1.01 * step ? until : std::max(0.0, now + step);
            if (!(refines && !m_path.points.empty() ? addRefined(next) : add(next))) {
                return;
            }
            now = next;
        }
    }

    bool addRefined(double next)
    {
        const PathPoint before = m_path.points.back();
        if (!add(next)) {
            return false;
        }
        const PathPoint& after = m_path.points.back();
        const double apart = std::max(std::abs(after.axes.azimuth.position - before.axes.azimuth.position),
                                      std::abs(after.axes.elevation.position - before.axes.elevation.position));
        if (apart <= kFarApart || next - before.seconds < 2.0 * kShortestStep) {
            return true;
        }
        m_path.points.pop_back();
        return addRefined(0.5 * (before.seconds + next)) && addRefined(next);
    }

    [[nodiscard]] double rate(std::size_t i, tracking::MotionState AxisStates::*axis) const
    {
        const PathPoint& from = m_path.points[i - 1];
        const PathPoint& to = m_path.points[i];
        return ((to.axes.*axis).position - (from.axes.*axis).position) / (to.seconds - from.seconds);
    }

    // Whether the axis is too slow before or at a point.
    [[nodiscard]] bool isFast(std::size_t i, tracking::MotionState AxisStates::*axis,
                              const tracking::MotionLimits& limits) const
    {
        const auto& points = m_path.points;
        if (std::abs(rate(i, axis)) > limits.speed.radians()) {
            return true;
        }
        const double apart = i + 1 < points.size() ? 0.5 * (points[i + 1].seconds - points[i - 1].seconds) : 1.0;
        const double change = i + 1 < points.size() ? rate(i + 1, axis) - rate(i, axis) : 0.0;
        return std::abs(change) > limits.acceleration.radians() * apart;
    }

    [[nodiscard]] std::optional<Times> fastTimes() const
    {
        const auto& points = m_path.points;
        std::optional<Times> found;
        for (std::size_t i = 1; i < points.size(); ++i) {
            if (isFast(i, &AxisStates::azimuth, m_mount.azimuth) ||
                isFast(i, &AxisStates::elevation, m_mount.elevation)) {
                const double to = points[std::min(i + 1, points.size() - 1)].seconds;
                found = Times{found ? found->from : points[i - 1].seconds, to};
            }
        }
        return found;
    }

    // Points at equal times around the fast part, with room for the longest ramp: two thirds of a turn.
    void makeFiner(const Times& fast, double step)
    {
        const auto room = [](const tracking::MotionLimits& limits) {
            return 240.0 / limits.speed.degrees() + 2.0 * limits.speed.degrees() / limits.acceleration.degrees() + 2.0;
        };
        const double around = std::max(room(m_mount.azimuth), room(m_mount.elevation));
        const double last = m_path.points.back().seconds;
        const Times ramp{std::max(0.0, fast.from - around), std::min(last, fast.to + around)};
        const double ramping = m_mount.azimuth.speed.degrees() / m_mount.azimuth.acceleration.degrees();
        const double fine =
            std::max(std::clamp(0.2 * ramping, kShortestStep, 0.1), (ramp.to - ramp.from) / kRampPoints);
        std::erase_if(m_path.points, [&](const PathPoint& point) { return point.seconds >= ramp.from; });
        addUntil(ramp.from, step, true);
        if (m_path.points.empty()) {
            add(0.0);
        }
        FastPart part{.begin = m_path.points.size() - 1};
        addUntil(ramp.to, fine, false);
        part.end = m_path.points.size() - 1;
        addUntil(last, step, true);
        const auto at = [this](double seconds) {
            const auto found = std::ranges::lower_bound(m_path.points, seconds, {}, &PathPoint::seconds);
            return std::min(static_cast<std::size_t>(found - m_path.points.begin()), m_path.points.size() - 1);
        };
        part.first = std::max(at(fast.from), part.begin);
        part.last = std::min(at(fast.to), part.end);
        m_path.fast = part;
    }

    void addRates()
    {
        auto& points = m_path.points;
        for (std::size_t i = 0; i < points.size() && points.size() > 1; ++i) {
            const PathPoint& from = points[i > 0 ? i - 1 : 0];
            const PathPoint& to = points[std::min(i + 1, points.size() - 1)];
            for (const auto side : {&PathPoint::axes, &PathPoint::overTheTop}) {
                for (const auto axis : {&AxisStates::azimuth, &AxisStates::elevation}) {
                    (points[i].*side.*axis).rate =
                        ((to.*side.*axis).position - (from.*side.*axis).position) / (to.seconds - from.seconds);
                }
            }
        }
    }

    [[nodiscard]] bool hides(const PathPoint& point) const
    {
        const pointing::AxisBox& ranges = m_mount.region.ranges();
        for (const int halfTurns : {0, 1}) {
            const AxisPosition axes = turned(point, halfTurns).place();
            const auto first = static_cast<int>(std::ceil((ranges.azimuth.min - axes.azimuth).turns()));
            const auto last = static_cast<int>(std::floor((ranges.azimuth.max - axes.azimuth).turns()));
            for (int wrap = first; wrap <= last; ++wrap) {
                const AxisPosition place{axes.azimuth + Angle::fromTurns(wrap), axes.elevation};
                if (m_mount.region.permits(onTheRim(place, ranges.elevation))) {
                    return false;
                }
            }
        }
        return true;
    }

    const DirectionAt& m_directionAt;
    UtcTime m_from;
    double m_length;
    const PlanMount& m_mount;
    PassPath m_path;
};

}  // namespace

AxisPosition AxisStates::place() const
{
    return {.azimuth = Angle::fromRadians(azimuth.position), .elevation = Angle::fromRadians(elevation.position)};
}

std::size_t PassPath::top() const
{
    const auto highest =
        std::ranges::max_element(points, {}, [](const PathPoint& point) { return point.axes.elevation.position; });
    return static_cast<std::size_t>(highest - points.begin());
}

PassPath pathOf(const DirectionAt& directionAt, UtcTime from, UtcTime to, const PlanMount& mount)
{
    return PathMaker(directionAt, from, to, mount).make();
}

AxisStates turned(const PathPoint& point, int halfTurns)
{
    const bool isOver = halfTurns % 2 != 0;
    AxisStates image = isOver ? point.overTheTop : point.axes;
    image.azimuth.position += (isOver ? halfTurns - 1 : halfTurns) * kPi;
    return image;
}

}  // namespace boresight::plan
