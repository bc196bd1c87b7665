// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QString>

// Why something about the drives themselves can not be done now, in words for the tooltip of its control; empty when
// it can. The station decides again.
namespace boresight::ui {

[[nodiscard]] QString whyNoReading(const StationStatus& status);
[[nodiscard]] QString whyNoFix(const StationStatus& status);
[[nodiscard]] QString whyNoSwitchOff(const StationStatus& status);
[[nodiscard]] QString whyNoRelease(const StationStatus& status);
[[nodiscard]] QString whyNoProof(const StationStatus& status);

}  // namespace boresight::ui
