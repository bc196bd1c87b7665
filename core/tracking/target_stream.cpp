// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/target_stream.h"

#include <algorithm>
#include <cmath>

namespace boresight::tracking {

namespace {

// The last points that have to lie along one line.
constexpr std::size_t kPointsInLine = 8;

// With longer pauses the points are not a stream, unless the client reads the position meanwhile. Points that are
// closer than kSpacing are thinned out. Otherwise the rounding of a moment would determine the path.
constexpr Seconds kLongestPause{5.0};
constexpr Seconds kSpacing{0.5};

// A point that is farther off the straight path belongs to another target. Satellites move at up to 2.3 °/s (200 km);
// anything faster is a slew.
constexpr double kMostDeviation = 1.0 * std::numbers::pi / 180.0;
constexpr double kFastest = 3.0 * std::numbers::pi / 180.0;

// A slower target is one point that is sent again and again. The stars move at 0.004 °/s.
constexpr double kSlowest = 0.001 * std::numbers::pi / 180.0;

// Points farther apart say too little about the path between them. Gpredict sends such points with its default
// threshold.
constexpr double kCoarsest = 2.5 * std::numbers::pi / 180.0;

// The largest distance of the target ahead of the last point, on the sky and in azimuth (which grows without limit near
// the zenith), and the longest time in average pauses.
constexpr double kFurthestAhead = 2.0 * std::numbers::pi / 180.0;
const Angle kFurthestAzimuth = Angle::fromDegrees(45.0);
constexpr double kPausesAhead = 2.0;

// A client that reads the position at least this often (Gpredict: every 0.8 s) and sends no point is content. The
// better the mount tracks, the longer the client is silent (16 s in a low orbit). The target then continues within
// these bounds and waits. If its position becomes wrong, Gpredict sends a point as soon as its satellite is off by the
// threshold. Only a longer silence is an end. A return to the last point after two pauses would swing the antenna 1.5°
// backwards in the middle of a pass, each time the mount had tracked well.
constexpr Seconds kReadsWithin{2.0};
constexpr Seconds kLongestRun{12.0};
constexpr Seconds kLongestWait{12.0};
constexpr double kFurthestRun = 5.0 * std::numbers::pi / 180.0;

// A content client may begin a stream with pauses longer than kLongestPause if its steps are this small. A Gpredict
// whose satellite is not tracked yet sends steps of twice its threshold. From a threshold of 0.25° on, such sparse
// points would form a path that leads the satellite by the threshold all the time. That is worse than no path.
constexpr double kFineStep = 0.5 * std::numbers::pi / 180.0;

// Each point changes the path a little. The target moves from the old path to the new one in this time, so that the
// antenna does not jerk with every point.
constexpr Seconds kCorrectionTime{1.0};

// The axis angles for a moving `direction`, on the turn and the side of the zenith of `near`.
MovingTarget axesFor(const SpaceVector& direction, const SpaceVector& rate, const AxisPosition& near)
{
    const double horizontal = std::max(std::hypot(direction[0], direction[1]), 1e-9);  // the zenith has no azimuth
    const double outwards = (direction[0] * rate[0] + direction[1] * rate[1]) / horizontal;
    const double length2 = horizontal * horizontal + direction[2] * direction[2];
    const Angle azimuth = Angle::fromRadians(std::atan2(direction[1], direction[0]));
    const Angle elevation = Angle::fromRadians(std::atan2(direction[2], horizontal));
    const double turning = (direction[0] * rate[1] - direction[1] * rate[0]) / (horizontal * horizontal);
    const double rising = (rate[2] * horizontal - direction[2] * outwards) / length2;
    const bool overTheTop = near.elevation > 90_deg;
    return {.position = {.azimuth = (overTheTop ? azimuth + 180_deg : azimuth).nearestTo(near.azimuth),
                         .elevation = overTheTop ? 180_deg - elevation : elevation},
            .rates = {.azimuth = AngularRate::fromRadians(turning),
                      .elevation = AngularRate::fromRadians(overTheTop ? -rising : rising)},
            .streaming = true};
}

}  // namespace

void TargetStream::restart(SteadyTime now, const AxisPosition& point)
{
    clear();
    add(now, point);
}

void TargetStream::clear()
{
    m_points.clear();
    m_paths.clear();
    m_path.reset();
    m_confirmed.reset();
}

void TargetStream::confirm(SteadyTime now)
{
    if (m_path && !target(now)->streaming) {
        m_path.reset();  // the path has ended, and a late read must not restore it
    }
    m_confirmed = now;
}

bool TargetStream::content(SteadyTime now) const
{
    return m_confirmed && now - *m_confirmed <= kReadsWithin;
}

// True if the next point belongs to the points before it.
bool TargetStream::continues(SteadyTime now, const AxisPosition& point) const
{
    const Seconds pause = now - m_points.back().time;
    if (pause <= kLongestPause) {
        return true;
    }
    const bool fine =
        pause <= kLongestRun + kLongestWait && distance(directionOf(point), m_points.back().direction) <= kFineStep;
    return content(now) && (fine || target(now)->streaming);
}

void TargetStream::add(SteadyTime now, const AxisPosition& point)
{
    if (!m_points.empty() && !continues(now, point)) {
        clear();
    }
    const auto before = target(now);
    const Point next{.time = now, .position = point, .direction = directionOf(point)};
    if (!m_points.empty() && now - m_points.back().time >= kSpacing) {
        m_paths.judge(next);
    }
    if (m_paths.hasTurned()) {
        m_points.erase(m_points.begin(), m_points.end() - 3);  // with the next one a line again
        m_paths.clear();
    }
    if (m_points.size() >= 2 && now - m_points[m_points.size() - 2].time < kSpacing) {
        m_points.pop_back();
    }
    m_points.push_back(next);
    if (m_points.size() > PathChoice::kMostPoints) {
        m_points.erase(m_points.begin());
    }
    updatePath();
    m_correction = {};
    if (const auto after = target(now); before && before->streaming && after->streaming) {
        m_correction = {.azimuth = before->position.azimuth - after->position.azimuth,
                        .elevation = before->position.elevation - after->position.elevation};
    }
}

// Drops the oldest points until the last ones lie along one line. Too slow or too fast is no path.
void TargetStream::updatePath()
{
    m_paths.fit(m_points);
    while (!areOnOnePath()) {
        const std::size_t kept = std::min(kPointsInLine, m_points.size()) - 1;
        m_points.erase(m_points.begin(), m_points.end() - static_cast<std::ptrdiff_t>(kept));
        m_paths.clear();
        m_paths.fit(m_points);
    }
    m_path = m_paths.best();
    if (!m_path) {
        return;
    }
    const double rate = distance(m_paths.straight()->rate, {});
    if (rate > kFastest || rate < kSlowest || rate * pause().count() > kCoarsest) {
        m_path.reset();
    }
}

bool TargetStream::areOnOnePath() const
{
    const std::optional<PointPath>& line = m_paths.straight();
    const auto first = m_points.end() - static_cast<std::ptrdiff_t>(std::min(kPointsInLine, m_points.size()));
    return !line || std::all_of(first, m_points.end(), [&](const Point& point) {
        const double time = Seconds(point.time - m_points.back().time).count();
        return distance(line->at(time), point.direction) <= kMostDeviation;
    });
}

// The average time between the last points.
Seconds TargetStream::pause() const
{
    const std::size_t count = std::min(kPointsInLine, m_points.size());
    const Seconds time = m_points.back().time - m_points[m_points.size() - count].time;
    return time / (static_cast<double>(count) - 1.0);
}

TargetStream::Reach TargetStream::reachOf(const PointPath& path, SteadyTime now) const
{
    if (!content(now)) {
        return {.run = kPausesAhead * std::min(pause(), kLongestPause), .wait = Seconds(0.0), .angle = kFurthestAhead};
    }
    return {.run = std::min(kLongestRun, Seconds(kFurthestRun / distance(path.rate, {}))),
            .wait = kLongestWait,
            .angle = kFurthestRun + kMostDeviation};  // the last point itself may be this far off the path
}

std::optional<AxisPosition> TargetStream::lastPoint() const
{
    return m_points.empty() ? std::nullopt : std::optional(m_points.back().position);
}

std::optional<StreamError> TargetStream::error(SteadyTime now) const
{
    if (m_points.size() < 2 || now - m_points.back().time > kLongestRun + kLongestWait) {
        return std::nullopt;
    }
    const double step = distance(m_points.back().direction, m_points[m_points.size() - 2].direction);
    const auto moving = target(now);
    const auto foretold = moving && moving->streaming ? m_paths.foretold() : std::nullopt;
    return StreamError{.step = Angle::fromRadians(step),
                       .foretold = foretold ? std::optional(Angle::fromRadians(*foretold)) : std::nullopt};
}

std::optional<MovingTarget> TargetStream::target(SteadyTime now) const
{
    if (m_points.empty()) {
        return std::nullopt;
    }
    const Point& last = m_points.back();
    const MovingTarget fixed{.position = last.position, .rates = {}, .streaming = false};
    if (!m_path) {
        return fixed;
    }
    const Seconds silent = now - last.time;
    const Reach reach = reachOf(*m_path, now);
    if (silent > reach.run + reach.wait) {
        return fixed;
    }
    const bool waits = silent > reach.run;
    const Seconds ahead = waits ? reach.run : silent;
    MovingTarget moving =
        axesFor(m_path->at(ahead.count()), waits ? SpaceVector{} : m_path->rateAt(ahead.count()), last.position);
    if (const double left = 1.0 - silent / kCorrectionTime; left > 0.0) {
        moving.position.azimuth += left * m_correction.azimuth;
        moving.position.elevation += left * m_correction.elevation;
        moving.rates.azimuth -= m_correction.azimuth / kCorrectionTime;
        moving.rates.elevation -= m_correction.elevation / kCorrectionTime;
    }
    const bool tooFar = distance(directionOf(moving.position), last.direction) > reach.angle ||
                        abs(moving.position.azimuth - last.position.azimuth) > kFurthestAzimuth;
    return tooFar ? fixed : moving;
}

}  // namespace boresight::tracking
