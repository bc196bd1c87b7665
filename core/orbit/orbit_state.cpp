// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/orbit/orbit_state.h"

#include "core/base/text.h"

namespace boresight::orbit {

QString describe(OrbitFault fault)
{
    switch (fault) {
        case OrbitFault::MeanEccentricity:
            return Text::tr(
                "The mean eccentricity is outside the range 0 to 1. The elements are not valid at this time.");
        case OrbitFault::MeanMotion:
            return Text::tr("The mean motion is not above 0. The elements are not valid at this time.");
        case OrbitFault::PerturbedEccentricity:
            return Text::tr(
                "Sun and Moon move the eccentricity out of the range 0 to 1. The elements are not valid at this time.");
        case OrbitFault::SemiLatusRectum:
            return Text::tr("The orbit is not an ellipse. The elements are not valid at this time.");
        case OrbitFault::Decayed:
            return Text::tr("The satellite has decayed. Its orbit is below the surface of the Earth.");
        case OrbitFault::TooFarFromEpoch:
            return Text::tr("The time is more than 100 years from the epoch of the elements.");
    }
    return {};
}

}  // namespace boresight::orbit
