// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/memory/mount_memory.h"

#include <QByteArray>

// A mount's memory as the text of its file: JSON with a version, and a checksum by which a torn or edited file is
// recognised. The format is described in JOURNAL.md. Pure, any thread. Doubles survive exactly, times to the
// millisecond.
namespace boresight::memory {

// Refuses what no axis can be: a number that is not finite or out of range, a drive without its UUID. So whatever was
// written can be read again.
[[nodiscard]] Result<QByteArray> toText(const MountMemory& memory);

// The reason is a clause for the operator: "its checksum is wrong: it was changed or damaged".
[[nodiscard]] Result<MountMemory> parseMemory(const QByteArray& text);

}  // namespace boresight::memory
