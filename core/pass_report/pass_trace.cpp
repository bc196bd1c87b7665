// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pass_report/pass_trace.h"

#include "core/pass_report/pass_summary.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace boresight::pass_report {

namespace {

using recording::Recording;
using recording::Tick;

// Between two ticks with more time a line is interrupted.
constexpr Seconds kInterrupted{1.0};

// Joins the values of each column of the time to their least and their largest.
class Thinned
{
public:
    explicit Thinned(Seconds column) : m_column(column) {}

    void add(const TracePoint& point)
    {
        if (!m_least || point.since >= m_end) {
            flush();
            m_end = m_column * (std::floor(point.since / m_column) + 1.0);
            m_least = m_largest = point;
        } else if (point.value < m_least->value) {
            m_least = point;
        } else if (point.value > m_largest.value) {
            m_largest = point;
        }
    }
    void interrupt()
    {
        flush();
        if (!m_line.back().empty()) {
            m_line.emplace_back();
        }
    }
    [[nodiscard]] TraceLine line()
    {
        flush();
        std::erase_if(m_line, [](const auto& piece) { return piece.empty(); });
        return m_line;
    }

private:
    void flush()
    {
        if (!m_least) {
            return;
        }
        const auto [first, second] = std::minmax(
            *m_least, m_largest, [](const TracePoint& a, const TracePoint& b) { return a.since < b.since; });
        m_line.back().push_back(first);
        if (second != first) {
            m_line.back().push_back(second);
        }
        m_least.reset();
    }

    Seconds m_column;
    Seconds m_end{};
    std::optional<TracePoint> m_least;
    TracePoint m_largest;
    TraceLine m_line = TraceLine(1);
};

// Joins the values of each column of the time to their mean, in the middle of their times.
class Averaged
{
public:
    explicit Averaged(Seconds column) : m_column(column) {}

    void add(const TracePoint& point)
    {
        if (m_count == 0 || point.since >= m_end) {
            flush();
            m_end = m_column * (std::floor(point.since / m_column) + 1.0);
        }
        m_since += point.since;
        m_sum += point.value;
        ++m_count;
    }
    void interrupt()
    {
        flush();
        if (!m_line.back().empty()) {
            m_line.emplace_back();
        }
    }
    [[nodiscard]] TraceLine line()
    {
        flush();
        std::erase_if(m_line, [](const auto& piece) { return piece.empty(); });
        return m_line;
    }

private:
    void flush()
    {
        if (m_count > 0) {
            const auto count = static_cast<double>(std::exchange(m_count, 0));
            m_line.back().push_back(
                {.since = std::exchange(m_since, Seconds(0.0)) / count, .value = std::exchange(m_sum, 0.0) / count});
        }
    }

    Seconds m_column;
    Seconds m_end{};
    Seconds m_since{};
    double m_sum = 0.0;
    std::size_t m_count = 0;
    TraceLine m_line = TraceLine(1);
};

bool isInterrupted(const std::vector<Tick>& ticks, std::size_t i)
{
    return i > 0 && ticks[i].utc - ticks[i - 1].utc > kInterrupted;
}

Seconds columnOf(const std::vector<Tick>& ticks, std::size_t columns)
{
    // A little longer, so that the last tick is in the last column and not alone in another.
    const Seconds whole = (1.0 + 1e-9) * Seconds(ticks.back().utc - ticks.front().utc);
    return std::max(whole / static_cast<double>(std::max<std::size_t>(columns, 1)), Seconds(1e-3));
}

template <class Joined>
TraceLine valueLine(const std::vector<Tick>& ticks, std::size_t columns,
                    const std::function<std::optional<double>(const Tick&)>& valueOf)
{
    Joined joined(columnOf(ticks, columns));
    for (std::size_t i = 0; i < ticks.size(); ++i) {
        const std::optional<double> value = valueOf(ticks[i]);
        if (!value || isInterrupted(ticks, i)) {
            joined.interrupt();
        }
        if (value) {
            joined.add({.since = ticks[i].utc - ticks.front().utc, .value = *value});
        }
    }
    return joined.line();
}

// A point for each column of the time.
SkyLine skyLine(const std::vector<Tick>& ticks, std::size_t columns, const std::optional<SkyPointing> Tick::*direction)
{
    SkyLine line(1);
    const Seconds column = columnOf(ticks, columns);
    Seconds next{};
    for (std::size_t i = 0; i < ticks.size(); ++i) {
        const std::optional<SkyPointing>& here = ticks[i].*direction;
        if ((!here || isInterrupted(ticks, i)) && !line.back().empty()) {
            line.emplace_back();
        }
        const Seconds since = ticks[i].utc - ticks.front().utc;
        if (here && (since >= next || line.back().empty() || i + 1 == ticks.size())) {
            line.back().push_back(upright(*here));
            next = since + column;
        }
    }
    std::erase_if(line, [](const auto& piece) { return piece.empty(); });
    return line;
}

// From the angles of the axes to the direction of the beam, for a mount whose axes are azimuth and elevation.
class AxisOffset
{
public:
    static std::optional<AxisOffset> of(const std::vector<Tick>& ticks)
    {
        std::optional<AxisOffset> offset;
        for (const Tick& tick : ticks) {
            if (!tick.actual || !tick.axes[0].actual || !tick.axes[1].actual) {
                continue;
            }
            const SkyPointing beam = upright(*tick.actual);
            const SkyPointing axes = upright({*tick.axes[0].actual, *tick.axes[1].actual});
            if (!offset) {
                offset = AxisOffset({beam.azimuth - axes.azimuth, beam.elevation - axes.elevation});
            }
            if (!offset->leadsTo(beam, axes)) {
                return std::nullopt;
            }
        }
        return offset;
    }

    [[nodiscard]] SkyPointing beam(const SkyPointing& axes) const
    {
        return upright({axes.azimuth + m_offset.azimuth, axes.elevation + m_offset.elevation});
    }

private:
    explicit AxisOffset(const SkyPointing& offset) : m_offset(offset) {}

    // Within 2°, which is more than what a pointing model corrects. On a page 2° are hardly seen.
    [[nodiscard]] bool leadsTo(const SkyPointing& expected, const SkyPointing& axes) const
    {
        constexpr Angle kNear = Angle::fromDegrees(2.0);
        const SkyPointing found = beam(axes);
        return abs(found.elevation - expected.elevation) < kNear &&
               abs((found.azimuth - expected.azimuth).wrapped180()) * std::cos(expected.elevation.radians()) < kNear;
    }

    SkyPointing m_offset;
};

SkyLine plannedBeam(const Recording& recording, std::size_t columns)
{
    const std::optional<AxisOffset> offset = AxisOffset::of(recording.ticks);
    if (!recording.plan || !offset || recording.plan->moments.empty()) {
        return {};
    }
    const auto& moments = recording.plan->moments;
    const std::size_t step = std::max<std::size_t>(moments.size() / std::max<std::size_t>(columns, 1), 1);
    SkyLine line(1);
    for (std::size_t i = 0; i < moments.size(); i += step) {
        line.back().push_back(offset->beam(upright({moments[i].axes.azimuth, moments[i].axes.elevation})));
    }
    return line;
}

}  // namespace

SkyPointing upright(const SkyPointing& direction)
{
    constexpr Angle kZenith = Angle::fromDegrees(90.0);
    if (direction.elevation <= kZenith) {
        return {direction.azimuth.wrapped360(), direction.elevation};
    }
    return {(direction.azimuth + 2.0 * kZenith).wrapped360(), 2.0 * kZenith - direction.elevation};
}

PassTrace traceOf(const Recording& recording, std::size_t columns)
{
    const std::vector<Tick>& ticks = recording.ticks;
    if (ticks.empty()) {
        return {};
    }
    const auto torqueOf = [](Axis axis) { return [axis](const Tick& tick) { return tick.axis(axis).torque; }; };
    const auto errorOf = [](const Tick& tick) {
        return tick.error ? std::optional(tick.error->degrees()) : std::nullopt;
    };
    PassTrace trace{.target = skyLine(ticks, columns, &Tick::target),
                    .beam = skyLine(ticks, columns, &Tick::actual),
                    .plan = plannedBeam(recording, columns),
                    .error = valueLine<Thinned>(ticks, columns, errorOf)};
    for (const Axis axis : kAxes) {
        trace.torque[index(axis)] = valueLine<Thinned>(ticks, columns, torqueOf(axis));
        trace.meanTorque[index(axis)] = valueLine<Averaged>(ticks, columns / kMeanOver, torqueOf(axis));
    }
    return trace;
}

}  // namespace boresight::pass_report
