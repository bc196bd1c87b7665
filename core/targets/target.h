// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/elements/element_set.h"
#include "core/ephemeris/sky_object.h"
#include "core/tables/table.h"
#include "core/units/site.h"
#include "core/units/sky.h"

#include <QString>

#include <variant>
#include <vector>

// A target for the mount: a satellite by its elements, a natural object in the sky, a fixed direction, a position on or
// above the Earth, or the path in a table. Pure value, any thread. target_path.h computes where it is.
namespace boresight::targets {

// The way around the Earth to a position: the shorter one, or the one over its other side.
enum class GreatCircle
{
    Short,
    Long
};

struct EarthPosition
{
    Site site;
    GreatCircle path = GreatCircle::Short;

    bool operator==(const EarthPosition&) const = default;
};

// A SkyPointing is a fixed direction. A table must not be null.
using TargetKind =
    std::variant<orbit::ElementSet, ephemeris::SkyObject, SkyPointing, EarthPosition, tables::SharedTable>;

struct Target
{
    QString name;  // as people read it: "ISS (ZARYA)", "Moon", "IM58kr"
    TargetKind kind;

    bool operator==(const Target&) const = default;
};

// The name of a satellite, or its number if it has no name.
[[nodiscard]] QString satelliteName(const orbit::ElementSet& elements);
[[nodiscard]] Target satelliteTarget(const orbit::ElementSet& elements);
// Sun, Moon, a planet or a radio source, by its name in the language of the program.
[[nodiscard]] Target objectTarget(const ephemeris::NamedObject& object);
// All of these: Sun and Moon, the planets, the radio sources.
[[nodiscard]] std::vector<Target> objectTargets();
[[nodiscard]] Target tableTarget(const tables::SharedTable& table);

// False for a fixed direction and a table of directions, which are already for one site.
[[nodiscard]] bool needsSite(const Target& target);
// A fixed direction or a position on the Earth, which never moves.
[[nodiscard]] bool stays(const Target& target);
// The Sun, which a profile may forbid.
[[nodiscard]] bool isSun(const Target& target);

}  // namespace boresight::targets
