// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sources/azel_moon.h"

#include "core/azel/moon_check.h"
#include "core/ephemeris/refraction.h"
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

bool AzelMoon::look(const ControlParts& view, const azel::AzelFeed& feed)
{
    const std::optional<Site> site = siteOf(view.profile.site);
    const bool isMoved = site != m_site;
    const bool isRuled = view.profile.orbit.refraction != m_rule;
    m_rule = view.profile.orbit.refraction;
    if (isMoved) {
        m_site = site;
        m_almanac = site ? std::optional(ephemeris::Almanac(*site)) : std::optional<ephemeris::Almanac>();
        m_path.reset();
        if (site) {
            m_path.emplace(targets::Target{.name = {}, .kind = ephemeris::SkyObject(Body::Moon)}, *site);
        }
    }
    if (m_path) {
        m_path->setRule(m_rule);
    }
    compare(feed, isMoved);
    return isMoved || isRuled;
}

void AzelMoon::compare(const azel::AzelFeed& feed, bool isMoved)
{
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

SkyPointing AzelMoon::step() const
{
    return ephemeris::apparent(m_step, ephemeris::refractionBy(m_rule, ephemeris::Refraction::Light));
}

SkyPointing AzelMoon::at(UtcTime utc)
{
    return interpolates() ? m_path->at(utc).value_or(step()) : step();
}

std::optional<AngularRate> AzelMoon::skyRate(UtcTime utc)
{
    constexpr std::chrono::seconds kApart{1};
    return interpolates() ? std::optional(angleBetween(at(utc), at(utc + kApart)) / kApart)
                          : std::optional<AngularRate>();
}

// The present time above the horizon has begun already, by the computed Moon. The file may differ from it.
std::optional<UtcTime> AzelMoon::nextRise(UtcTime from)
{
    std::optional<targets::UpTime> up = nextUp(from);
    if (up && up->rises <= from) {
        up = up->sets ? nextUp(*up->sets + ephemeris::kShortestUp) : std::nullopt;
    }
    return up ? std::optional(up->rises) : std::nullopt;
}

std::optional<UtcTime> AzelMoon::nextSet(UtcTime from)
{
    const std::optional<targets::UpTime> up = nextUp(from);
    return up ? up->sets : std::nullopt;
}

std::optional<targets::UpTime> AzelMoon::nextUp(UtcTime from)
{
    if (!m_path) {
        return std::nullopt;
    }
    const Result<targets::UpTime> up = m_path->nextUp(from);
    return up ? std::optional(*up) : std::nullopt;
}

}  // namespace boresight::sources
