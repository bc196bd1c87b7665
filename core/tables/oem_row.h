// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/tables/table.h"

#include <string_view>

// A row of an OEM: a time, a position in km and a velocity in km/s. Three accelerations may follow and are ignored.
// Pure.
namespace boresight::tables {

[[nodiscard]] Result<OrbitRow> oemRow(std::string_view line, TimeSystem system);

// Whether a plausible path leads from one row to the next. The error explains why not.
[[nodiscard]] Result<> follows(const OrbitRow& before, const OrbitRow& row);

}  // namespace boresight::tables
