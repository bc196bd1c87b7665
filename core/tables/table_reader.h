// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/tables/table.h"

#include <QString>

#include <string_view>

// Reads a table in any supported format. An OEM is recognised by its beginning; any other text is a tracking table.
// Pure.
namespace boresight::tables {

// `file` is the name in messages: "FILE:LINE: reason". Its last part becomes the name of a tracking table.
[[nodiscard]] Result<SharedTable> readTable(std::string_view text, const QString& file);

}  // namespace boresight::tables
