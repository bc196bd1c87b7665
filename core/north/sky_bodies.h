// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ephemeris/almanac.h"
#include "core/ephemeris/refraction.h"
#include "core/profile/profile.h"

#include <QString>

#include <array>
#include <optional>

// Where Sun and Moon appear from one site, and when they rise and set next. A time is searched again only after it has
// passed, and one search per call, because a search takes a millisecond or more of a tick. Station thread only.
namespace boresight {

inline constexpr std::array kBodies = {ephemeris::Body::Sun, ephemeris::Body::Moon};

[[nodiscard]] QString bodyName(ephemeris::Body body);

class SkyBodies
{
public:
    explicit SkyBodies(const profile::SiteSettings& site);

    // Without a known site nothing is reported.
    [[nodiscard]] bool known() const { return m_almanac.has_value(); }
    // The apparent direction, with refraction.
    [[nodiscard]] std::optional<SkyPointing> direction(ephemeris::Body body, ephemeris::Refraction kind, UtcTime utc);

    // Finds one of the times of rising and setting that are unknown or due for a new search.
    void lookAhead(UtcTime utc);
    struct Times
    {
        std::optional<UtcTime> rise;
        std::optional<UtcTime> set;
    };
    // The times that were found until now.
    [[nodiscard]] Times times(ephemeris::Body body) const;

private:
    struct Search
    {
        std::optional<UtcTime> found;
        UtcTime from;
        UtcTime until;  // then the search is made again
    };
    struct Searches
    {
        std::optional<Search> rise;
        std::optional<Search> set;
    };

    std::optional<ephemeris::Almanac> m_almanac;
    std::array<Searches, kBodies.size()> m_searches;
};

}  // namespace boresight
