// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <optional>

class QSaveFile;

namespace boresight {

// Gives the file its name if all of it is on the disk, else the file that was there stays. QSaveFile::commit alone does
// not know of a last write that failed (Qt 6.4): on a full disk a profile became an empty file, and was reported as
// stored. Empty: done. Else why not.
[[nodiscard]] std::optional<QString> saveWhole(QSaveFile& file);

}  // namespace boresight
