// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <QString>

// The file that says "on" or "off", with a line end. It is written in place, so that its owner and rights stay, and so
// that it can be emptied where a disk is full. A reader that sees anything but "on", also nothing, has to take it for
// off. Each call renews its time, by which a reader knows a program that died. Any thread; may block.
namespace boresight::transmit {

[[nodiscard]] Result<> writeState(const QString& path, bool on);

}  // namespace boresight::transmit
