// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

// Statuses of a mount during its calibration. The hidden truth: the azimuth axis shows 0° at true north + 37.4°, the
// sensor has ±8° of hard-iron and ±3° of soft-iron deviation, and the mast leans by 0.6°.
namespace boresight::samples {

[[nodiscard]] StationStatus beforeCalibration();    // nothing found yet, the sensor's compass is not calibrated
[[nodiscard]] StationStatus swinging();             // half way through a swing
[[nodiscard]] StationStatus swung();                // the swing's north is proposed
[[nodiscard]] StationStatus heard();                // the same, with readings of the sensor
[[nodiscard]] StationStatus swungInVain();          // a place where a compass is of no use
[[nodiscard]] StationStatus followingSun();         // three points taken, the Sun is tracked and trimmed
[[nodiscard]] StationStatus followingOverTheTop();  // the same on a mount whose boom goes past the zenith
[[nodiscard]] StationStatus scanning();             // waits for a power
[[nodiscard]] StationStatus scanned();              // a Sun of 3 dB was found
[[nodiscard]] StationStatus sixPoints();            // six points, their model is proposed; two older calibrations

}  // namespace boresight::samples
