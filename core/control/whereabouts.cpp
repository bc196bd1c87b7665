// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/control/whereabouts.h"

#include "core/base/text.h"
#include "core/control/gates.h"
#include "core/pointing/nearest_permitted.h"

namespace boresight {

Result<AxisPosition> Whereabouts::measured() const
{
    for (const Axis axis : kAxes) {
        if (const Result<> fresh = Gates(m_of).isFresh(axis); !fresh) {
            return tl::unexpected(fresh.error());
        }
    }
    if (!m_of.mount.wrapsKnown()) {
        return failure(ErrorCode::NoAnswer, Text::tr("the cable wrap of an axis is unknown"));
    }
    return *m_of.mount.measured();
}

std::optional<SkyPointing> Whereabouts::direction() const
{
    return directionBy(m_of.model.pointing().terms());
}

std::optional<SkyPointing> Whereabouts::directionBy(const pointing::PointingTerms& terms) const
{
    pointing::MountModel model = m_of.model;
    model.setPointing(pointing::PointingModel(terms));
    const auto place = measured();
    return place ? std::optional(model.toSky(*place)) : std::nullopt;
}

std::optional<AxisPosition> Whereabouts::trimInUse() const
{
    const bool followsClient = m_of.current.commander().kind == SourceKind::Client && m_of.current.moves();
    return m_of.current.is(Activity::Streaming) && followsClient ? std::optional(m_of.motion.trim()) : std::nullopt;
}

std::optional<AxisPosition> Whereabouts::streamGoal() const
{
    const auto& region = m_of.motion.region();
    const auto& point = m_of.current.point();
    return !point || region.permits(*point) ? point : pointing::nearestPermitted(region, *point);
}

AxisPosition Whereabouts::untrimmedGoal() const
{
    const AxisPosition goal = m_of.motion.target(m_of.now).value_or(m_of.stoppingPlace());
    const AxisPosition& trim = m_of.motion.trim();
    return {.azimuth = goal.azimuth - trim.azimuth, .elevation = goal.elevation - trim.elevation};
}

std::optional<Angle> Whereabouts::cableEnd() const
{
    constexpr Angle kSamePlace = Angle::fromDegrees(0.1);
    constexpr Angle kThere = Angle::fromDegrees(1.0);
    const bool waits = m_of.current.keepsWrap() || !m_of.current.limitedReason().isEmpty();
    const bool hasCable =
        m_of.mount.capabilities().has(Axis::Azimuth) && !m_of.model.pointing().isXY() && m_of.mount.wrapsKnown();
    if (!m_of.current.is(Activity::Streaming) || !waits || !hasCable) {
        return std::nullopt;
    }
    const std::optional<AxisPosition> target = m_of.motion.target(m_of.now);
    const TravelRange& range = m_of.motion.region().ranges().azimuth;
    for (const Angle end : {range.min, range.max}) {
        if (target && abs(target->azimuth - end) < kSamePlace && abs(m_of.motion.place().azimuth - end) < kThere) {
            return end;
        }
    }
    return std::nullopt;
}

}  // namespace boresight
