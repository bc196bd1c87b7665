// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/quantity.h"

// The Earth's magnetic field at one place and time, in its usual parts: nanotesla, and angles from true north and the
// horizon. Plain values.
namespace boresight::geomagnetism {

struct FieldParts
{
    double north = 0.0;       // X, nT
    double east = 0.0;        // Y
    double down = 0.0;        // Z
    double horizontal = 0.0;  // H
    double total = 0.0;       // F
    Angle declination;        // D, from true north to the compass needle, east positive
    Angle inclination;        // I, of the needle below the horizon

    bool operator==(const FieldParts&) const = default;
};

struct MagneticField
{
    FieldParts now;
    FieldParts changePerYear;

    bool operator==(const MagneticField&) const = default;
};

// How far a compass can be trusted at a place, by the horizontal field, which turns it: the zones of the World Magnetic
// Model.
enum class CompassZone
{
    Good,
    Caution,  // below 6000 nT
    Blackout  // below 2000 nT, around the magnetic poles: a compass is of no use
};

[[nodiscard]] constexpr CompassZone compassZone(const FieldParts& field)
{
    return field.horizontal < 2000.0   ? CompassZone::Blackout
           : field.horizontal < 6000.0 ? CompassZone::Caution
                                       : CompassZone::Good;
}

}  // namespace boresight::geomagnetism
