// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/guards/sun_watch.h"

#include "core/ephemeris/refraction.h"
#include "core/pointing/missing_axis.h"
#include "core/pointing/pointing_model.h"
#include "core/pointing/sun_keep_out.h"
#include "core/units/angle_between.h"

#include <algorithm>
#include <utility>

namespace boresight {

SunWatch::SunWatch(const profile::InForce& profile) : m_profile(profile)
{
    begin();
}

void SunWatch::profileChanged(const profile::Profile& before, const profile::Profile& after)
{
    if (before.sun != after.sun || before.site != after.site) {
        begin();
    }
}

void SunWatch::setSpread(Angle spread)
{
    if (std::exchange(m_spread, spread) != spread) {
        m_looked.reset();
    }
}

Angle SunWatch::keptFree() const
{
    return std::min(m_profile->sun.radius + m_spread + kMargin, 90_deg);
}

void SunWatch::begin()
{
    const profile::SiteSettings& site = m_profile->site;
    m_looked.reset();
    m_almanac.reset();
    if (m_profile->sun.keepAway == profile::KeepAway::On && site.known) {
        m_almanac.emplace(site.place());
    }
}

bool SunWatch::update(const Clock& clock)
{
    const UtcTime utc = clock.utc();
    const bool doubted = m_almanac && !m_trust.update(clock, m_profile->sun.clock);
    if (m_looked && abs(utc - *m_looked) < kRenewal && doubted == m_doubted) {
        return false;
    }
    m_looked = utc;
    m_doubted = doubted;
    std::vector<pointing::KeepOut> keepOuts =
        doubted ? pointing::sunBand(m_profile->site.latitude, keptFree()) : around(utc);
    const bool changed = keepOuts != m_keepOuts;
    m_keepOuts = std::move(keepOuts);
    return changed;
}

std::vector<pointing::KeepOut> SunWatch::around(UtcTime utc)
{
    if (!m_almanac) {
        return {};
    }
    m_direction =
        ephemeris::apparent(m_almanac->place(ephemeris::Body::Sun, utc).direction, ephemeris::Refraction::Light);
    const auto keepOut = pointing::sunKeepOut(m_direction, keptFree());
    return keepOut ? std::vector{*keepOut} : std::vector<pointing::KeepOut>{};
}

bool SunWatch::mayBeAt(const SkyPointing& beam, std::optional<Axis> missing) const
{
    const auto holds = [at = pointing::upright(beam), missing](const pointing::KeepOut& keepOut) {
        const Angle width = (keepOut.azimuthTo - keepOut.azimuthFrom).wrapped360();
        const Angle into = (at.azimuth - keepOut.azimuthFrom).wrapped360();
        const bool inAzimuth = into > 0_deg && into < width;
        const bool inElevation = at.elevation > keepOut.elevationMin && at.elevation < keepOut.elevationMax;
        return (inAzimuth || missing == Axis::Azimuth) && (inElevation || missing == Axis::Elevation);
    };
    return m_doubted && std::ranges::any_of(m_keepOuts, holds);
}

std::optional<Angle> SunWatch::distance(const SkyPointing& beam, std::optional<Axis> missing) const
{
    if (m_doubted || m_keepOuts.empty()) {
        return std::nullopt;
    }
    return missing ? pointing::leastAngleBetween(beam, m_direction, *missing) : angleBetween(beam, m_direction);
}

}  // namespace boresight
