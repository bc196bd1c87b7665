// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/north/sky_bodies.h"

#include "core/base/text.h"
#include "core/ephemeris/rise_set.h"

#include <algorithm>

namespace boresight {
namespace {

// If a body neither rises nor sets, the search is repeated after this time.
constexpr std::chrono::hours kSearchAgain{1};
// The true elevation of the middle of the disc when it appears at the horizon: refraction lifts it by 34'.
constexpr Angle kAtHorizon = Angle::fromDegrees(-34.0 / 60.0);

std::size_t index(ephemeris::Body body)
{
    return body == ephemeris::Body::Sun ? 0 : 1;
}

// Also due if the clock was set back.
template <class Search>
bool isDue(const std::optional<Search>& search, UtcTime utc)
{
    return !search || utc >= search->until || utc < search->from;
}

}  // namespace

QString bodyName(ephemeris::Body body)
{
    return body == ephemeris::Body::Sun ? Text::tr("Sun") : Text::tr("Moon");
}

SkyBodies::SkyBodies(const profile::SiteSettings& site)
{
    if (site.known) {
        m_almanac.emplace(site.place());
    }
}

std::optional<SkyPointing> SkyBodies::direction(ephemeris::Body body, ephemeris::Refraction kind, UtcTime utc)
{
    if (!m_almanac) {
        return std::nullopt;
    }
    return ephemeris::apparent(m_almanac->place(body, utc).direction, kind);
}

void SkyBodies::lookAhead(UtcTime utc)
{
    if (!m_almanac) {
        return;
    }
    const auto made = [utc](std::optional<UtcTime> found) {
        const UtcTime again = utc + kSearchAgain;
        return Search{.found = found, .from = utc, .until = std::min(again, found.value_or(again))};
    };
    for (const ephemeris::Body body : kBodies) {
        Searches& searches = m_searches[index(body)];
        if (isDue(searches.rise, utc)) {
            searches.rise = made(ephemeris::nextRise(*m_almanac, body, utc, kAtHorizon));
            return;
        }
        if (isDue(searches.set, utc)) {
            searches.set = made(ephemeris::nextSet(*m_almanac, body, utc, kAtHorizon));
            return;
        }
    }
}

SkyBodies::Times SkyBodies::times(ephemeris::Body body) const
{
    const Searches& searches = m_searches[index(body)];
    return {.rise = searches.rise ? searches.rise->found : std::nullopt,
            .set = searches.set ? searches.set->found : std::nullopt};
}

}  // namespace boresight
