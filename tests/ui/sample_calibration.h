// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

// Statuses of a mount whose north is being found: hidden truth is an axis that shows 0° where true north + 37.4° is, a
// sensor with ±8° of hard and ±3° of soft iron, and a mast that leans by 0.6°.
namespace boresight::samples {

[[nodiscard]] StationStatus beforeCalibration();    // nothing found yet, the sensor's compass is not calibrated
[[nodiscard]] StationStatus swinging();             // half way through a swing
[[nodiscard]] StationStatus swung();                // the swing's north is proposed
[[nodiscard]] StationStatus heard();                // the same, and the sensor is heard
[[nodiscard]] StationStatus swungInVain();          // magnetically hopeless
[[nodiscard]] StationStatus followingSun();         // three points taken, the Sun is followed and trimmed
[[nodiscard]] StationStatus followingOverTheTop();  // the same on a mount whose boom goes past the zenith
[[nodiscard]] StationStatus scanning();             // waits for a power
[[nodiscard]] StationStatus scanned();              // a Sun of 3 dB was found
[[nodiscard]] StationStatus sixPoints();            // six points, their model is proposed; two older calibrations

}  // namespace boresight::samples
