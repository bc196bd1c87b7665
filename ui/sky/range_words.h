// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QString>

// How far a satellite is now, and by how much its frequencies are shifted. Only while it is above the horizon: then a
// radio is tuned. Gui thread.
namespace boresight::ui {

// "812 km, -4.12 km/s, Doppler +13.7 Hz/MHz": the range falls, so frequencies arrive higher, by 13.7 Hz for each MHz.
// Of the full second. Empty: it is below the horizon, or its orbit cannot be computed.
[[nodiscard]] QString rangeText(const orbit::ElementSet& elements, const Site& site, UtcTime utc);
// Shorter, for the header: "812 km, -4.12 km/s, +13.7 Hz/MHz". Of the satellite that is tracked, by the elements that
// the station has. Empty: no satellite.
[[nodiscard]] QString trackedRangeText(const StationStatus& status);

}  // namespace boresight::ui
