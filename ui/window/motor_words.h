// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QString>

#include <optional>

// What is shown of an axis under the pointer. Pure.
namespace boresight::ui {

// Its state, its step, and how often its motor started if it is one that is only switched on and off. May be empty.
// `can`: empty if there is no such axis.
[[nodiscard]] QString axisHelp(const AxisStatus& axis, const std::optional<AxisCapabilities>& can);

}  // namespace boresight::ui
