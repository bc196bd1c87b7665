// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/tables/table.h"

#include <string_view>

// A row of an OEM: a time, a place in km and a velocity in km/s. Three accelerations behind them are left out. Pure.
namespace boresight::tables {

[[nodiscard]] Result<OrbitRow> oemRow(std::string_view line, TimeSystem system);

// Whether a way leads from one row to the next. The error says what is in the way.
[[nodiscard]] Result<> follows(const OrbitRow& before, const OrbitRow& row);

}  // namespace boresight::tables
