// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <QString>

// Writes the file that contains "on" or "off", with a line end. The file is written in place. So it keeps its owner and
// its access rights, and it can be emptied on a full disk. A reader must treat anything but "on" as off, also an empty
// file. Each call renews the modification time, so an old time shows the reader that Boresight died. Any thread; may
// block.
namespace boresight::outputs {

[[nodiscard]] Result<> writeState(const QString& path, bool on);

}  // namespace boresight::outputs
