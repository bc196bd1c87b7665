// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/sky.h"

#include <QString>

namespace boresight {

// What became of a target that a client sent, in words: "az 40.0° (one turn less)". `goal` is where the beam goes, with
// the azimuth that the client is told there; `limited` is why the target itself is not reached. Empty when the client
// wrote the same: also for 360° where the circle is counted from 0°.
[[nodiscard]] QString targetReading(const SkyPointing& asked, const SkyPointing& goal, const QString& limited);

}  // namespace boresight
