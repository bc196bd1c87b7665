// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <optional>

class QSaveFile;

namespace boresight {

// Gives the file its final name only if all of it is on the disk. Otherwise the old file stays. QSaveFile::commit alone
// ignores a failed last write (Qt 6.4): on a full disk it stored an empty profile and reported success. Empty: stored.
// Otherwise the reason.
[[nodiscard]] std::optional<QString> saveWhole(QSaveFile& file);

}  // namespace boresight
