// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <optional>

namespace boresight {

// Another program that has this device open, as "tview (process 1234)"; its links are followed. Other users' programs
// are seen by root only. Reads /proc: a few milliseconds.
[[nodiscard]] std::optional<QString> portHolder(const QString& device);

}  // namespace boresight
