// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QString>

// Why a control of the North panel cannot act now, in words for its tooltip; empty when it can. The station decides
// again: this only keeps the screen from offering what would be refused.
namespace boresight::ui {

[[nodiscard]] const BodyNow* bodyNow(const StationStatus& status, ephemeris::Body body);  // null: not known

[[nodiscard]] QString whyNoSensorAverage(const StationStatus& status);
[[nodiscard]] QString whyNoSwing(const StationStatus& status);
// To follow it; over the top, with the boom past the zenith.
[[nodiscard]] QString whyNoBody(const StationStatus& status, ephemeris::Body body, bool overTheTop);
[[nodiscard]] QString whyNoScan(const StationStatus& status, ephemeris::Body body);
[[nodiscard]] QString whyNoPower(const StationStatus& status);
[[nodiscard]] QString whyNoBodyPoint(const StationStatus& status, ephemeris::Body body);
[[nodiscard]] QString whyNoLandmark(const StationStatus& status);
[[nodiscard]] QString whyNoPointChange(const StationStatus& status);
[[nodiscard]] QString whyNoGivenTerms(const StationStatus& status);  // typed, or from a file
[[nodiscard]] QString whyNoApply(const StationStatus& status);
[[nodiscard]] QString whyNoDiscard(const StationStatus& status);
[[nodiscard]] QString whyNoUndo(const StationStatus& status);
[[nodiscard]] QString whyNoRedo(const StationStatus& status);

}  // namespace boresight::ui
