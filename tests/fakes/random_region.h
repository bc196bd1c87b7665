// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pointing/pointing_model.h"
#include "core/pointing/region.h"

#include <algorithm>
#include <random>
#include <string>

// Random regions of all kinds for tests with random walks. What they forbid is computed independently of the core, in a
// simple way. All values in degrees.
namespace boresight::fakes {

class RandomRegion
{
public:
    explicit RandomRegion(std::mt19937& random) : m_random(random) {}

    double uniform(double from, double to) { return std::uniform_real_distribution<double>(from, to)(m_random); }
    int dice(int sides) { return std::uniform_int_distribution<int>(0, sides - 1)(m_random); }

    TravelRange azimuthTravel()
    {
        switch (dice(4)) {
            case 0:
                return range(0, 360);
            case 1:
                return range(-200, 460);
            case 2:
                return range(-180, 180);
            default: {
                const double min = uniform(-200, 100);
                return range(min, min + uniform(60, 560));
            }
        }
    }
    TravelRange elevationTravel() { return dice(3) == 0 ? range(0, 180) : dice(2) == 0 ? range(0, 90) : range(-5, 95); }

    pointing::Region region()
    {
        pointing::Region region;
        if (dice(3) == 0) {
            region.azimuth = {angle(-150, 20), angle(200, 420)};
            region.elevation = {angle(-10, 20), angle(60, 170)};
        }
        if (dice(3) > 0) {
            const int count = 1 + dice(20);
            const double highest = dice(3) == 0 ? 80.0 : 30.0;
            for (int i = 0; i < count; ++i) {
                region.horizon.push_back({.azimuth = Angle::fromDegrees((i + uniform(0.05, 0.95)) * 360.0 / count),
                                          .elevation = Angle::fromDegrees(uniform(-5, highest))});
            }
        }
        const int count = dice(6);
        for (int i = 0; i < count; ++i) {
            region.keepOuts.push_back(keepOut(i));
        }
        return region;
    }

    pointing::KeepOut keepOut(int number)
    {
        const double from = uniform(0, 360);
        const double bottom = dice(2) == 0 ? uniform(-5, 0) : uniform(0, 70);
        return {.name = "number " + std::to_string(number),
                .azimuthFrom = Angle::fromDegrees(from),
                .azimuthTo = Angle::fromDegrees(from + uniform(2, 90)).wrapped360(),
                .elevationMin = Angle::fromDegrees(bottom),
                .elevationMax = Angle::fromDegrees(std::min(90.0, bottom + uniform(2, 60)))};
    }

    AxisPosition place(const TravelRange& azimuths, const TravelRange& elevations)
    {
        return {.azimuth = angle(azimuths.min.degrees(), azimuths.max.degrees()),
                .elevation = angle(elevations.min.degrees(), elevations.max.degrees())};
    }

private:
    Angle angle(double from, double to) { return Angle::fromDegrees(uniform(from, to)); }
    static TravelRange range(double min, double max) { return {Angle::fromDegrees(min), Angle::fromDegrees(max)}; }

    std::mt19937& m_random;
};

inline double horizonAt(const pointing::Region& region, double azimuth)
{
    const auto& points = region.horizon;
    if (points.empty()) {
        return -3600.0;
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double from = points[i].azimuth.degrees();
        const auto& next = points[(i + 1) % points.size()];
        const double to = next.azimuth.degrees() + (i + 1 == points.size() ? 360.0 : 0.0);
        for (const double x : {azimuth, azimuth + 360.0}) {
            if (x >= from && x <= to) {
                const double part = (x - from) / (to - from);
                return (1.0 - part) * points[i].elevation.degrees() + part * next.elevation.degrees();
            }
        }
    }
    return -3600.0;
}

// The depth of a place inside the forbidden area: how far the axes must go, straight up or sideways, to leave its worst
// part. Zero or less where the place is permitted.
inline double depthInside(const pointing::Region& region, const AxisPosition& place,
                          const pointing::PointingModel& model = {})
{
    const SkyPointing beam = pointing::upright(model.toSky(place));
    const double azimuth = beam.azimuth.degrees();
    const double elevation = beam.elevation.degrees();
    double depth =
        std::max({(region.azimuth.min - place.azimuth).degrees(), (place.azimuth - region.azimuth.max).degrees(),
                  (region.elevation.min - place.elevation).degrees(),
                  (place.elevation - region.elevation.max).degrees(), horizonAt(region, azimuth) - elevation});
    for (const pointing::KeepOut& keepOut : region.keepOuts) {
        const double width = (keepOut.azimuthTo - keepOut.azimuthFrom).wrapped360().degrees();
        const double into = (beam.azimuth - keepOut.azimuthFrom).wrapped360().degrees();
        const double sideways = std::min(into, width - into);  // negative beside the keep-out
        const double upwards =
            std::min(elevation - keepOut.elevationMin.degrees(), keepOut.elevationMax.degrees() - elevation);
        depth = std::max(depth, std::min(sideways, upwards));
    }
    return depth;
}

}  // namespace boresight::fakes
