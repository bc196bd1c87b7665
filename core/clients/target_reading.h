// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/sky.h"

#include <QString>

namespace boresight {

// Describes where the beam goes for a target of a client, for example "az 40.0° (one turn less)". `goal` is the
// direction of the beam, with the azimuth that the client receives there. `limited` is why the target itself is not
// reached. Empty when the client sent this direction, also as 360° for 0°.
[[nodiscard]] QString targetReading(const SkyPointing& asked, const SkyPointing& goal, const QString& limited);

}  // namespace boresight
