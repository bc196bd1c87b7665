// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pointing/antenna.h"

#include "core/units/angle_between.h"

namespace boresight::pointing {

PointingTerms termsFor(PointingTerms main, const Antenna& antenna, std::optional<Axis> missing)
{
    (missing == Axis::Elevation ? main.azimuthOffset : main.collimation) += antenna.across;
    main.elevationOffset += antenna.up;
    return main;
}

// Treats the two offsets as coordinates on a globe whose pole is the elevation axis.
Angle beamDistance(const Antenna& one, const Antenna& other)
{
    return angleBetween(SkyPointing{.azimuth = one.up, .elevation = one.across},
                        SkyPointing{.azimuth = other.up, .elevation = other.across});
}

}  // namespace boresight::pointing
