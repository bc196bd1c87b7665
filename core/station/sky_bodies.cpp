// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/sky_bodies.h"

#include "core/base/text.h"
#include "core/ephemeris/rise_set.h"

#include <algorithm>

namespace boresight {
namespace {

// Where nothing rises or sets, it is looked for again this often.
constexpr std::chrono::hours kSearchAgain{1};
// The middle of the disc at the horizon as it appears: the air lifts it by 34'.
constexpr Angle kAtHorizon = Angle::fromDegrees(-34.0 / 60.0);

std::size_t index(ephemeris::Body body)
{
    return body == ephemeris::Body::Sun ? 0 : 1;
}

}  // namespace

QString bodyName(ephemeris::Body body)
{
    return body == ephemeris::Body::Sun ? Text::tr("Sun") : Text::tr("Moon");
}

void SkyBodies::setSite(const profile::SiteSettings& site)
{
    if (m_almanac && site == m_site) {
        return;
    }
    m_site = site;
    m_searched = {};
    m_almanac.reset();
    if (site.known) {
        m_almanac.emplace(
            Site{.latitude = site.latitude, .longitude = site.longitude, .heightMetres = site.heightMetres});
    }
}

std::optional<SkyPointing> SkyBodies::direction(ephemeris::Body body, ephemeris::Refraction kind, UtcTime utc)
{
    if (!m_almanac) {
        return std::nullopt;
    }
    return ephemeris::apparent(m_almanac->place(body, utc).direction, kind);
}

const SkyBodies::Times& SkyBodies::times(ephemeris::Body body, UtcTime utc)
{
    auto& searched = m_searched[index(body)];
    if (m_almanac && (!searched || utc >= searched->until || utc < searched->from)) {
        const Times times{.rise = ephemeris::nextRise(*m_almanac, body, utc, kAtHorizon),
                          .set = ephemeris::nextSet(*m_almanac, body, utc, kAtHorizon)};
        const UtcTime until = utc + kSearchAgain;
        searched = Searched{.times = times,
                            .from = utc,
                            .until = std::min({until, times.rise.value_or(until), times.set.value_or(until)})};
    }
    static const Times kNone;
    return searched ? searched->times : kNone;
}

}  // namespace boresight
