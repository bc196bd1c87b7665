// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/orbit/orbit_state.h"

#include "core/base/text.h"

namespace boresight::orbit {

QString describe(OrbitFault fault)
{
    switch (fault) {
        case OrbitFault::MeanEccentricity:
            return Text::tr("The mean eccentricity leaves the range 0 to 1: the elements do not hold at this time.");
        case OrbitFault::MeanMotion:
            return Text::tr("The mean motion is not above 0: the elements do not hold at this time.");
        case OrbitFault::PerturbedEccentricity:
            return Text::tr("Sun and Moon drive the eccentricity out of the range 0 to 1: the elements do not hold.");
        case OrbitFault::SemiLatusRectum:
            return Text::tr("The orbit is no ellipse at this time: the elements do not hold.");
        case OrbitFault::Decayed:
            return Text::tr("The satellite has decayed: the orbit is below the surface of the Earth.");
        case OrbitFault::TooFarFromEpoch:
            return Text::tr("The time is more than 100 years from the epoch of the elements.");
    }
    return {};
}

}  // namespace boresight::orbit
