// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QString>

// What is shown of an axis under the pointer. Pure.
namespace boresight::ui {

// Its state, and how often its motor started if it is one that is only switched on and off. May be empty.
[[nodiscard]] QString axisHelp(const AxisStatus& axis);

}  // namespace boresight::ui
