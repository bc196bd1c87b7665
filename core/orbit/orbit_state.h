// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/orbit/vector.h"

#include <QString>

#include <tl/expected.hpp>

// The result of a propagation: the position of the satellite, or why the theory has no answer. Pure values.
namespace boresight::orbit {

struct OrbitState
{
    Vector position;  // km, TEME
    Vector velocity;  // km/s

    bool operator==(const OrbitState&) const = default;
};

// The codes up to 6 are those published with SGP4 (AIAA 2006-6753), which no longer uses 5.
enum class OrbitFault
{
    MeanEccentricity = 1,       // outside [-0.001, 1)
    MeanMotion = 2,             // not above 0
    PerturbedEccentricity = 3,  // outside [0, 1]
    SemiLatusRectum = 4,        // below 0
    Decayed = 6,                // below the radius of the Earth
    TooFarFromEpoch = 7,        // our own code: more than 100 years, or an invalid time
};

// An error has no text, because one search computes millions of states.
using OrbitResult = tl::expected<OrbitState, OrbitFault>;

[[nodiscard]] QString describe(OrbitFault fault);

}  // namespace boresight::orbit
