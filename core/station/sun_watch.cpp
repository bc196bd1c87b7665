// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/sun_watch.h"

#include "core/ephemeris/refraction.h"
#include "core/pointing/sun_keep_out.h"
#include "core/units/angle_between.h"

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

bool SunWatch::update(UtcTime utc)
{
    if (m_looked && abs(utc - *m_looked) < kRenewal) {
        return false;
    }
    m_looked = utc;
    std::optional<pointing::KeepOut> keepOut;
    if (m_almanac) {
        m_direction =
            ephemeris::apparent(m_almanac->place(ephemeris::Body::Sun, utc).direction, ephemeris::Refraction::Light);
        keepOut = pointing::sunKeepOut(m_direction, m_sun.radius + kMargin);
    }
    const bool changed = keepOut != m_keepOut;
    m_keepOut = keepOut;
    return changed;
}

std::optional<Angle> SunWatch::distance(const SkyPointing& beam) const
{
    return m_keepOut ? std::optional(angleBetween(beam, m_direction)) : std::nullopt;
}

}  // namespace boresight
