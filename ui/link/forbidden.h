// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QString>

#include <optional>

namespace boresight::ui {

// Why the profile in force, or the Sun, does not let the mount point there, in the words of the core; empty if it does.
// Advice before the click: the station decides again.
[[nodiscard]] QString whyForbidden(const StationStatus& status, const SkyPointing& direction);
// The nearest direction that is allowed; empty where `direction` itself is, and where nothing is.
[[nodiscard]] std::optional<SkyPointing> nearestAllowed(const StationStatus& status, const SkyPointing& direction);

}  // namespace boresight::ui
