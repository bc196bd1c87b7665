// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ephemeris/almanac.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

// A natural object in the sky, with the name that operators use: Sun and Moon, the planets, the strongest radio
// sources, or any position among the stars. Pure.
namespace boresight::ephemeris {

using SkyObject = std::variant<Body, Planet, StarPlace>;

struct NamedObject
{
    std::string_view key;   // "cas-a"
    std::string_view name;  // "Cas A", for Text::of()
    SkyObject object;
};

// The objects with a name: Sun and Moon, the planets, the radio sources.
[[nodiscard]] std::span<const NamedObject> namedObjects();

// By a key in small letters: sun, moon, mercury … neptune, cas-a, cyg-a, tau-a, vir-a, sgr-a. Empty for any other text.
[[nodiscard]] std::optional<SkyObject> skyObject(std::string_view key);

// All keys, for a message: "sun, moon, mercury, …".
[[nodiscard]] std::string skyObjectKeys();

// True direction, without refraction.
struct SeenObject
{
    SkyPointing direction;
    std::optional<double> kilometres;  // empty for a position among the stars
};

[[nodiscard]] SeenObject see(Almanac& almanac, const SkyObject& object, UtcTime utc);

}  // namespace boresight::ephemeris
