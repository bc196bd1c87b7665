// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <string_view>

namespace boresight::drive_check {

// The name of a safety setting for the operator: "Lower limit". The lower limit of a reversed drive is the upper limit
// of the axis. A setting without a name has its key. Pure values, any thread.
[[nodiscard]] QString settingName(std::string_view key, bool reversed);

}  // namespace boresight::drive_check
