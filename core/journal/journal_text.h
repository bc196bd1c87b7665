// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/journal/mount_journal.h"

#include <QByteArray>

// A mount's journal as the text of its file: JSON with a version, and a checksum that reveals a torn or edited file.
// JOURNAL.md describes the format. Doubles are stored exactly, times to the millisecond. Pure, any thread.
namespace boresight::journal {

// Refuses values that no axis can have: a number that is not finite or out of range, a drive without a UUID. So
// everything that was written can be read again.
[[nodiscard]] Result<QByteArray> toText(const MountJournal& journal);

// A refusal has a clause for the operator: "its checksum is wrong: it was changed or damaged".
[[nodiscard]] Result<MountJournal> parseJournal(const QByteArray& text);

}  // namespace boresight::journal
