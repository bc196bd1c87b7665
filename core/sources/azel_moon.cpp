// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sources/azel_moon.h"

#include "core/azel/moon_check.h"
#include "core/ephemeris/rise_set.h"
#include "core/units/angle_between.h"

namespace boresight::sources {

using azel::MoonCheck;
using ephemeris::Body;

namespace {

std::optional<Site> siteOf(const profile::SiteSettings& site)
{
    return site.known ? std::optional(site.place()) : std::optional<Site>();
}

}  // namespace

void AzelMoon::look(const ControlParts& view, const azel::AzelFeed& feed)
{
    const std::optional<Site> site = siteOf(view.profile.site);
    const bool isMoved = site != m_site;
    if (isMoved) {
        m_site = site;
        m_almanac = site ? std::optional(ephemeris::Almanac(*site)) : std::optional<ephemeris::Almanac>();
    }
    if (!feed.text()) {
        m_apart.reset();
        return;
    }
    m_step = feed.text()->moon;
    if (isMoved || feed.time() != m_compared || !m_apart) {
        m_compared = feed.time();
        m_apart = m_almanac ? std::optional(azel::moonApart(feed, *m_almanac)) : std::optional<Angle>();
    }
}

bool AzelMoon::interpolates() const
{
    return m_apart && azel::moonCheck(*m_apart) == MoonCheck::Agrees;
}

bool AzelMoon::differs() const
{
    return m_apart && azel::moonCheck(*m_apart) == MoonCheck::Differs;
}

bool AzelMoon::isElsewhere() const
{
    return m_apart && azel::moonCheck(*m_apart) == MoonCheck::Elsewhere;
}

SkyPointing AzelMoon::at(UtcTime utc)
{
    return interpolates() ? m_almanac->place(Body::Moon, utc).direction : m_step;
}

std::optional<AngularRate> AzelMoon::skyRate(UtcTime utc)
{
    constexpr std::chrono::seconds kApart{1};
    return interpolates() ? std::optional(angleBetween(at(utc), at(utc + kApart)) / kApart)
                          : std::optional<AngularRate>();
}

std::optional<UtcTime> AzelMoon::nextRise(UtcTime from)
{
    return m_almanac ? ephemeris::nextRise(*m_almanac, Body::Moon, from, {}) : std::optional<UtcTime>();
}

std::optional<UtcTime> AzelMoon::nextSet(UtcTime from)
{
    return m_almanac ? ephemeris::nextSet(*m_almanac, Body::Moon, from, {}) : std::optional<UtcTime>();
}

}  // namespace boresight::sources
