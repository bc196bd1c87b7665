// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ephemeris/sky_object.h"

#include "core/base/overloaded.h"

#include <algorithm>
#include <array>

namespace boresight::ephemeris {

namespace {

struct NamedObject
{
    std::string_view key;
    SkyObject object;
};

StarPlace star(double hours, double minutes, double seconds, Angle declination)
{
    return {.rightAscension = Angle::fromDegrees(15.0 * (hours + minutes / 60.0 + seconds / 3600.0)),
            .declination = declination};
}

// Places of J2000. Cas A: the centre of its expansion (Thorstensen et al., Astronomical Journal 122, 2001). Cyg A,
// Vir A and Sgr A*: the compact sources in the International Celestial Reference Frame. Tau A: the pulsar in it.
const std::array kObjects{
    NamedObject{"sun", Body::Sun},
    NamedObject{"moon", Body::Moon},
    NamedObject{"mercury", Planet::Mercury},
    NamedObject{"venus", Planet::Venus},
    NamedObject{"mars", Planet::Mars},
    NamedObject{"jupiter", Planet::Jupiter},
    NamedObject{"saturn", Planet::Saturn},
    NamedObject{"uranus", Planet::Uranus},
    NamedObject{"neptune", Planet::Neptune},
    NamedObject{"cas-a", star(23.0, 23.0, 27.77, 58.81372_deg)},
    NamedObject{"cyg-a", star(19.0, 59.0, 28.357, 40.733916_deg)},
    NamedObject{"tau-a", star(5.0, 34.0, 31.94, 22.01450_deg)},
    NamedObject{"vir-a", star(12.0, 30.0, 49.423, 12.391123_deg)},
    NamedObject{"sgr-a", star(17.0, 45.0, 40.041, -29.007811_deg)},
};

}  // namespace

std::optional<SkyObject> skyObject(std::string_view key)
{
    const auto found = std::ranges::find(kObjects, key, &NamedObject::key);
    return found == kObjects.end() ? std::nullopt : std::optional(found->object);
}

std::string skyObjectKeys()
{
    std::string keys;
    for (const NamedObject& named : kObjects) {
        keys += (keys.empty() ? "" : ", ") + std::string(named.key);
    }
    return keys;
}

SeenObject see(Almanac& almanac, const SkyObject& object, UtcTime utc)
{
    const auto near = [](const BodyPlace& place) { return SeenObject{place.direction, place.kilometres}; };
    return std::visit(Overloaded{[&](Body body) { return near(almanac.place(body, utc)); },
                                 [&](Planet planet) { return near(almanac.place(planet, utc)); },
                                 [&](const StarPlace& star) {
                                     return SeenObject{almanac.direction(star, utc), {}};
                                 }},
                      object);
}

}  // namespace boresight::ephemeris
