// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/passes/favourite_places.h"

#include <algorithm>

namespace boresight::ui {

namespace {

constexpr std::size_t kMostFollowed = 200;

}  // namespace

void FavouritePlaces::setBasis(const Satellites& satellites, const orbit::SatelliteMarks& marks,
                               const std::optional<Site>& site)
{
    if (satellites == m_satellites && marks == m_marks && site == m_site) {
        return;
    }
    m_satellites = satellites;
    m_marks = marks;
    m_site = site;
    m_favourites.clear();
    if (!satellites || !site || marks.empty()) {
        return;
    }
    for (const orbit::ElementSet& elements : *satellites) {
        if (m_favourites.size() < kMostFollowed && orbit::isFavourite(marks, elements.number)) {
            m_favourites.push_back(
                {.number = elements.number, .name = targets::satelliteName(elements), .orbit = orbit::Sgp4(elements)});
        }
    }
}

std::vector<SatellitePlace> FavouritePlaces::at(UtcTime utc, const std::optional<std::int64_t>& without)
{
    std::vector<SatellitePlace> places;
    if (m_favourites.empty()) {
        return places;
    }
    const orbit::Observer observer(*m_site);
    const orbit::JulianDate date = orbit::julianDate(utc);
    for (One& one : m_favourites) {
        const auto state = one.orbit.propagate(date, one.resonance);
        if (!state || one.number == without) {
            continue;
        }
        const SkyPointing direction = observer.look(orbit::groundState(*state, date)).direction;
        if (direction.elevation >= 0_deg) {
            places.push_back({.name = one.name, .direction = targets::satelliteSeen(direction, m_refraction)});
        }
    }
    std::ranges::sort(places, std::ranges::greater(),
                      [](const SatellitePlace& place) { return place.direction.elevation; });
    places.resize(std::min(places.size(), kMostFavouritePlaces));
    return places;
}

}  // namespace boresight::ui
