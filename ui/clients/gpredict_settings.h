// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QString>

// The settings that Gpredict needs to use this mount, with the names in its dialogs, ready to be copied.
namespace boresight::ui {

[[nodiscard]] QString gpredictSettings(const StationStatus& status);  // several lines
[[nodiscard]] QString gpredictInBrief(const StationStatus& status);   // one line

}  // namespace boresight::ui
