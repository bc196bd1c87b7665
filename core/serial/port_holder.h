// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <optional>

namespace boresight {

// The other program that has this device open, as "tview (process 1234)". Links to the device are resolved. Programs of
// other users are visible only to root. Reads /proc, which takes a few milliseconds.
[[nodiscard]] std::optional<QString> portHolder(const QString& device);

}  // namespace boresight
