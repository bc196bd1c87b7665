// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/control/region_keeper.h"

#include "core/alarms/catalogue.h"
#include "core/base/text.h"
#include "core/pointing/nearest_permitted.h"
#include "core/pointing/sun_keep_out.h"

#include <algorithm>
#include <cmath>

namespace boresight {
namespace {

// An axis that stands at a limit may be measured slightly beyond it.
constexpr Angle kAtTheEdge = Angle::fromDegrees(0.5);

// The distance on the sky.
Angle distance(const AxisPosition& a, const AxisPosition& b)
{
    const double across = (a.azimuth - b.azimuth).degrees() * std::cos(a.elevation.radians());
    return Angle::fromDegrees(std::hypot(across, (a.elevation - b.elevation).degrees()));
}

}  // namespace

RegionKeeper::RegionKeeper(const Parts& parts) : m_of(parts), m_sun(parts.profile), m_sunAlarms(parts.alarms) {}

void RegionKeeper::begin()
{
    m_sun.setSpread(m_of.antenna.spread());
    (void)m_sun.update(m_of.clock);
    layOutLimits();
    enforce();
}

void RegionKeeper::profileChanged(const profile::Profile& before, const profile::Profile& after)
{
    m_sun.profileChanged(before, after);
    m_sun.setSpread(m_of.antenna.spread());
    const bool redrawn = before.limits != after.limits || m_of.antenna.terms() != m_terms;
    if (redrawn) {
        layOutLimits();
    }
    renew(redrawn);
}

void RegionKeeper::antennaChanged()
{
    m_sun.setSpread(m_of.antenna.spread());
    const bool redrawn = m_of.antenna.terms() != m_terms;
    if (redrawn) {
        layOutLimits();
    }
    renew(redrawn);
}

void RegionKeeper::step()
{
    renew(false);
    const ControlParts view = m_of.helm.view();
    const auto measured = view.mount.measured();
    const bool known = measured && view.mount.wrapsKnown();
    m_sunAlarms.update(m_sun, known ? distanceToSun(*measured) : std::nullopt, m_of.model.missing());
    watchPlace(known ? measured : std::nullopt);
}

// The distance of the Sun to the nearest beam. Beams that are not in use count as well, because the Sun can damage
// them, too.
std::optional<Angle> RegionKeeper::distanceToSun(const AxisPosition& measured) const
{
    if (m_sun.keepOuts().empty()) {
        return std::nullopt;
    }
    std::optional<Angle> nearest;
    pointing::MountModel model = m_of.model;
    for (const pointing::Antenna& one : m_of.profile->allAntennas()) {
        model.setPointing(pointing::PointingModel(m_of.profile->termsOf(one)));
        const auto distance = m_sun.distance(model.toSky(measured), model.missing());
        nearest = nearest && distance ? std::min(nearest, distance) : distance;
    }
    return nearest;
}

void RegionKeeper::layOutLimits()
{
    const profile::Profile& profile = *m_of.profile;
    m_terms = m_of.antenna.terms();
    m_limits.emplace(profile.limits, profile.azimuth.geometry.travel, profile.elevation.geometry.travel,
                     pointing::PointingModel(m_terms));
}

// Reports a mount that stands outside the limits: the limits were changed, or the mount was found or pushed there.
void RegionKeeper::watchPlace(const std::optional<AxisPosition>& measured)
{
    const AlarmEntry& outside = alarmEntry("limits.outside");
    if (!measured || m_limits->permits(*measured)) {
        m_of.alarms.clear(outside);
        return;
    }
    const auto nearest = pointing::nearestPermitted(*m_limits, *measured);
    if (m_of.alarms.active(outside) || !nearest || distance(*measured, *nearest) > kAtTheEdge) {
        m_of.alarms.raise(outside, {m_limits->obstacle(*measured)});
    }
}

// When the clock becomes trusted, a motion that the band held back ends where it is. When the clock becomes doubted, a
// motion inside the band ends there.
void RegionKeeper::renew(bool redrawn)
{
    const Motion& motion = m_of.motion;
    const bool before = m_sun.clockDoubted();
    const bool heldBack =
        motion.limited() || !motion.noWay().isEmpty() || motion.held(Axis::Azimuth) || motion.held(Axis::Elevation);
    if (m_sun.update(m_of.clock) || redrawn) {
        enforce();
    }
    const bool doubted = m_sun.clockDoubted();
    const auto isConcerned = [&] { return doubted ? Gates(m_of.helm.view()).isInSunBand(motion.place()) : heldBack; };
    if (doubted != before && m_of.helm.current().moves() && isConcerned()) {
        end(doubted ? Text::tr("the clock of this computer is not synchronised")
                    : Text::tr("the position of the Sun is known again"));
    }
}

// Updates the permitted region, and the conversion between axes and directions. Moves nothing.
void RegionKeeper::enforce()
{
    Motion& motion = m_of.motion;
    const CurrentMotion& current = m_of.helm.current();
    const SteadyTime now = m_of.helm.now();
    // If a client sends no more points, its last point also counts as a place. It does not if the mount holds at the
    // nearest permitted place instead.
    const bool standing = current.is(Activity::Streaming) && !motion.streaming(now) && !motion.limited();
    m_of.model.setPointing(pointing::PointingModel(m_of.antenna.terms()));
    motion.setRegion(pointing::withSun(m_of.profile->limits, m_sun.keepOuts()), m_of.model.pointing());
    const pointing::AxisBox& ranges = motion.region().ranges();
    m_of.model.limitTo(ranges.azimuth, ranges.elevation);
    const auto target = motion.target(now);
    const bool going = current.goesToAPlace() || standing;
    if (const QString why = going && target ? motion.region().reason(*target) : QString(); !why.isEmpty()) {
        end(why);  // otherwise a mount that stands would start by itself
    }
}

void RegionKeeper::end(const QString& why)
{
    m_of.log.add(Severity::Warning, QStringLiteral("station"), Text::tr("ends the motion: %1").arg(why));
    m_of.helm.hold(Activity::Holding);
}

}  // namespace boresight
