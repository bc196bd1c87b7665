// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/control/slew_watch.h"

#include <algorithm>

namespace boresight {
namespace {

// One prediction costs as much as many ticks.
constexpr std::chrono::milliseconds kBetweenLooks{500};
// The way is planned again when the set-points are this far off the plan, or the end has moved this far.
constexpr Angle kOffCourse = Angle::fromDegrees(0.8);
constexpr Angle kAnotherEnd = Angle::fromDegrees(0.1);
// A moving target whose predicted meeting point differs by more than this is predicted again.
constexpr Angle kMetElsewhere = Angle::fromDegrees(2.0) + Course::kMet;
// A target that jumps by more than this begins another slew.
constexpr Angle kAnotherTarget = Angle::fromDegrees(1.0);
constexpr Angle kDrawnStep = Angle::fromDegrees(1.0);

bool isNear(const AxisPosition& a, const AxisPosition& b, Angle within)
{
    return abs(a.azimuth - b.azimuth) <= within && abs(a.elevation - b.elevation) <= within;
}

AxisPosition after(const tracking::MovingTarget& target, Seconds time)
{
    return {.azimuth = target.position.azimuth + target.rates.azimuth * time,
            .elevation = target.position.elevation + target.rates.elevation * time};
}

}  // namespace

void SlewWatch::update(bool slewing, const Motion& motion, SteadyTime now)
{
    const auto target = slewing ? motion.target(now) : std::nullopt;
    if (!target) {
        *this = {};
        return;
    }
    if (!m_target || !isNear(*m_target, *target, kAnotherTarget)) {
        m_began = now;
        m_look.reset();
    }
    m_target = target;
    const bool due = !m_look || now - m_look->when >= kBetweenLooks;
    if (due && !isAsExpected(motion, *target, now)) {
        m_look = {.when = now, .course = motion.noWay().isEmpty() ? Course::of(motion, now) : std::nullopt};
    }
}

bool SlewWatch::isAsExpected(const Motion& motion, const AxisPosition& target, SteadyTime now) const
{
    if (!m_look || !m_look->course) {
        return false;
    }
    const Course& course = *m_look->course;
    const Seconds gone = now - m_look->when;
    if (!isNear(course.at(gone), motion.place(), kOffCourse)) {
        return false;
    }
    const auto path = motion.path(now);
    return path ? isNear(course.end(), after(*path, course.duration() - gone), kMetElsewhere)
                : isNear(course.end(), target, kAnotherEnd);
}

std::optional<SlewProgress> SlewWatch::progress(SteadyTime now) const
{
    if (!m_look || !m_look->course) {
        return std::nullopt;
    }
    const Seconds remaining = std::max(Seconds(0.0), m_look->course->duration() - Seconds(now - m_look->when));
    const Seconds whole = Seconds(now - m_began) + remaining;
    return SlewProgress{.remaining = remaining, .done = whole > Seconds(0.0) ? 1.0 - remaining / whole : 1.0};
}

std::vector<AxisPosition> SlewWatch::way(SteadyTime now) const
{
    return m_look && m_look->course ? m_look->course->rest(now - m_look->when, kDrawnStep)
                                    : std::vector<AxisPosition>();
}

}  // namespace boresight
