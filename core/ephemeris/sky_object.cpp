// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ephemeris/sky_object.h"

#include "core/base/overloaded.h"

#include <QtGlobal>

#include <algorithm>
#include <array>

namespace boresight::ephemeris {

namespace {

StarPlace star(double hours, double minutes, double seconds, Angle declination)
{
    return {.rightAscension = Angle::fromDegrees(15.0 * (hours + minutes / 60.0 + seconds / 3600.0)),
            .declination = declination};
}

// Positions of J2000. Cas A: the centre of its expansion (Thorstensen et al., Astronomical Journal 122, 2001). Cyg A,
// Vir A and Sgr A*: the compact sources in the International Celestial Reference Frame. Tau A: its pulsar.
const std::array kObjects{
    NamedObject{"sun", QT_TRANSLATE_NOOP("Text", "Sun"), Body::Sun},
    NamedObject{"moon", QT_TRANSLATE_NOOP("Text", "Moon"), Body::Moon},
    NamedObject{"mercury", QT_TRANSLATE_NOOP("Text", "Mercury"), Planet::Mercury},
    NamedObject{"venus", QT_TRANSLATE_NOOP("Text", "Venus"), Planet::Venus},
    NamedObject{"mars", QT_TRANSLATE_NOOP("Text", "Mars"), Planet::Mars},
    NamedObject{"jupiter", QT_TRANSLATE_NOOP("Text", "Jupiter"), Planet::Jupiter},
    NamedObject{"saturn", QT_TRANSLATE_NOOP("Text", "Saturn"), Planet::Saturn},
    NamedObject{"uranus", QT_TRANSLATE_NOOP("Text", "Uranus"), Planet::Uranus},
    NamedObject{"neptune", QT_TRANSLATE_NOOP("Text", "Neptune"), Planet::Neptune},
    NamedObject{"cas-a", "Cas A", star(23.0, 23.0, 27.77, 58.81372_deg)},
    NamedObject{"cyg-a", "Cyg A", star(19.0, 59.0, 28.357, 40.733916_deg)},
    NamedObject{"tau-a", "Tau A", star(5.0, 34.0, 31.94, 22.01450_deg)},
    NamedObject{"vir-a", "Vir A", star(12.0, 30.0, 49.423, 12.391123_deg)},
    NamedObject{"sgr-a", "Sgr A*", star(17.0, 45.0, 40.041, -29.007811_deg)},
};

}  // namespace

std::span<const NamedObject> namedObjects()
{
    return kObjects;
}

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
