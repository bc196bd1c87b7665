// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/control/sun_watch.h"

#include "core/ephemeris/refraction.h"
#include "core/pointing/pointing_model.h"
#include "core/pointing/sun_keep_out.h"
#include "core/units/angle_between.h"

#include <algorithm>

namespace boresight {

void SunWatch::setProfile(const profile::Profile& profile)
{
    if (profile.sun == m_sun && profile.site == m_site) {
        return;
    }
    m_sun = profile.sun;
    m_site = profile.site;
    m_looked.reset();
    m_almanac.reset();
    if (m_sun.keepAway == profile::KeepAway::On && m_site.known) {
        m_almanac.emplace(
            Site{.latitude = m_site.latitude, .longitude = m_site.longitude, .heightMetres = m_site.heightMetres});
    }
}

bool SunWatch::update(const Clock& clock)
{
    const UtcTime utc = clock.utc();
    const bool doubted = m_almanac && !m_trust.update(clock, m_sun.clock);
    if (m_looked && abs(utc - *m_looked) < kRenewal && doubted == m_doubted) {
        return false;
    }
    m_looked = utc;
    m_doubted = doubted;
    std::vector<pointing::KeepOut> keepOuts =
        doubted ? pointing::sunBand(m_site.latitude, m_sun.radius + kMargin) : around(utc);
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
    const auto keepOut = pointing::sunKeepOut(m_direction, m_sun.radius + kMargin);
    return keepOut ? std::vector{*keepOut} : std::vector<pointing::KeepOut>{};
}

bool SunWatch::mayBeAt(const SkyPointing& beam) const
{
    return m_doubted &&
           std::ranges::any_of(m_keepOuts, [at = pointing::upright(beam)](const pointing::KeepOut& keepOut) {
               const Angle width = (keepOut.azimuthTo - keepOut.azimuthFrom).wrapped360();
               const Angle into = (at.azimuth - keepOut.azimuthFrom).wrapped360();
               return into > 0_deg && into < width && at.elevation > keepOut.elevationMin &&
                      at.elevation < keepOut.elevationMax;
           });
}

std::optional<Angle> SunWatch::distance(const SkyPointing& beam) const
{
    return m_doubted || m_keepOuts.empty() ? std::nullopt : std::optional(angleBetween(beam, m_direction));
}

}  // namespace boresight
