// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/tables/table.h"

#include <QString>

#include <string_view>

// Reads a table in whichever form it is: an OEM by its first word, all else is a tracking table. Pure.
namespace boresight::tables {

// `file` is how messages name it: "FILE:LINE: reason". Its last part is the name of a tracking table.
[[nodiscard]] Result<SharedTable> readTable(std::string_view text, const QString& file);

}  // namespace boresight::tables
