// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/tables/table.h"

#include <QString>

// A table of a file. Blocking, for seconds where it is a large one: not on the gui thread, nor the station's.
namespace boresight::tables {

inline constexpr qint64 kMostTableMegabytes = 100;

// The error begins with the path. Only a file: a pipe would keep the reader waiting.
[[nodiscard]] Result<SharedTable> readTableFile(const QString& path);

}  // namespace boresight::tables
