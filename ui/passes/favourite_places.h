// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/elements/satellite_mark.h"
#include "core/orbit/sgp4.h"
#include "core/orbit/topocentric.h"
#include "core/targets/target_path.h"
#include "ui/passes/pass_book.h"
#include "ui/sky/sky_satellites.h"

#include <optional>
#include <vector>

// The directions of the favourites that are above the horizon. A call with 200 favourites takes less than a
// millisecond. Gui thread.
namespace boresight::ui {

class FavouritePlaces
{
public:
    // Empty `site`: the site is unknown, so no satellite is shown.
    void setBasis(const Satellites& satellites, const orbit::SatelliteMarks& marks, const std::optional<Site>& site);
    // The rule of the profile, so that a favourite is shown where the mount would point to it.
    void setRefraction(ephemeris::RefractionRule rule) { m_refraction = rule; }
    // The highest ones. `without` is left out, because the tracked satellite has its own mark.
    [[nodiscard]] std::vector<SatellitePlace> at(UtcTime utc, const std::optional<std::int64_t>& without);

private:
    struct One
    {
        std::int64_t number = 0;
        QString name;
        orbit::Sgp4 orbit;
        orbit::ResonanceState resonance = {};
    };

    Satellites m_satellites;
    orbit::SatelliteMarks m_marks;
    std::optional<Site> m_site;
    ephemeris::RefractionRule m_refraction = ephemeris::RefractionRule::ByKind;
    std::vector<One> m_favourites;
};

inline constexpr std::size_t kMostFavouritePlaces = 20;

}  // namespace boresight::ui
