// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QString>

// The range of a satellite and the Doppler shift of its frequencies. Only while it is above the horizon, when a radio
// is tuned to it. Gui thread.
namespace boresight::ui {

// "812 km, -4.12 km/s, Doppler +13.7 Hz/MHz": the range decreases, so received frequencies are higher, by 13.7 Hz for
// each MHz. Computed for the full second. Empty if the satellite is below the horizon or its orbit cannot be computed.
[[nodiscard]] QString rangeText(const orbit::ElementSet& elements, const Site& site, UtcTime utc);
// A shorter form for the header: "812 km, -4.12 km/s, +13.7 Hz/MHz". For the tracked satellite, with the elements of
// the station. Empty if no satellite is tracked.
[[nodiscard]] QString trackedRangeText(const StationStatus& status);

}  // namespace boresight::ui
