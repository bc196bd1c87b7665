// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/passes/ground_track.h"

#include "core/orbit/sgp4.h"
#include "core/orbit/topocentric.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

namespace boresight::ui {

namespace {

constexpr int kTrackSteps = 120;
constexpr int kFootprintPoints = 72;
constexpr double kEarthMetres = 6'371'000.0;  // the mean radius of the Earth

std::optional<Site> below(const orbit::Sgp4& orbit, UtcTime utc)
{
    const orbit::JulianDate date = orbit::julianDate(utc);
    const auto state = orbit.propagate(date);
    return state ? std::optional(orbit::subSatellitePoint(orbit::groundState(*state, date).position)) : std::nullopt;
}

std::vector<Site> trackOf(const orbit::Sgp4& orbit, UtcTime from, UtcTime::duration length)
{
    std::vector<Site> track;
    for (int step = 0; step <= kTrackSteps; ++step) {
        if (const auto place = below(orbit, from + length * step / kTrackSteps)) {
            track.push_back(*place);
        }
    }
    return track;
}

}  // namespace

GroundTrack groundTrackOf(const BookedPass& one, const PassBook& book)
{
    const orbit::Sgp4 orbit(book.elementsOf(one));
    const passes::Pass& pass = one.pass;
    const double minutes = std::min(orbit.periodMinutes(), orbit::kMinutesPerDay);
    const auto turn = std::chrono::duration_cast<UtcTime::duration>(Seconds(60.0 * (minutes > 0.0 ? minutes : 0.0)));
    return {.pass = trackOf(orbit, pass.aos.utc, pass.los.utc - pass.aos.utc),
            .after = trackOf(orbit, pass.los.utc, turn)};
}

std::optional<Site> placeBelow(const orbit::ElementSet& elements, UtcTime utc)
{
    return below(orbit::Sgp4(elements), utc);
}

std::vector<Site> footprintOf(const Site& below)
{
    const double reach = std::acos(kEarthMetres / (kEarthMetres + std::max(below.heightMetres, 0.0)));
    const double latitude = below.latitude.radians();
    std::vector<Site> edge;
    for (int point = 0; point <= kFootprintPoints; ++point) {
        const double bearing = 2.0 * std::numbers::pi * point / kFootprintPoints;
        const double sine =
            std::sin(latitude) * std::cos(reach) + std::cos(latitude) * std::sin(reach) * std::cos(bearing);
        const double east = std::atan2(std::sin(bearing) * std::sin(reach) * std::cos(latitude),
                                       std::cos(reach) - std::sin(latitude) * sine);
        edge.push_back({.latitude = Angle::fromRadians(std::asin(std::clamp(sine, -1.0, 1.0))),
                        .longitude = (below.longitude + Angle::fromRadians(east)).wrapped180()});
    }
    return edge;
}

}  // namespace boresight::ui
