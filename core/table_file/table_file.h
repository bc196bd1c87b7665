// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/tables/table.h"

#include <QString>

// Reads a table from a file. Blocking, for seconds if the file is large: neither on the gui thread nor on the station
// thread.
namespace boresight::tables {

inline constexpr qint64 kMostTableMegabytes = 100;

// The error begins with the path. Only a regular file: a pipe would block the reader.
[[nodiscard]] Result<SharedTable> readTableFile(const QString& path);

}  // namespace boresight::tables
