// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tables/table.h"
#include "core/tables/table_problem.h"

#include <string>
#include <string_view>

// Orbit ephemeris messages as KVN: CCSDS 502.0-B, section 5. Of one object, around the Earth. Accelerations,
// covariances and comments are left out. Pure.
namespace boresight::tables {

struct Oem
{
    std::string name;  // of the object; printable, may be empty
    OrbitSegments segments;
};

// What every such text begins with.
inline constexpr std::string_view kOemStart = "CCSDS_OEM_VERS";

[[nodiscard]] TableReading<Oem> readOem(std::string_view text);

// The usable times. Segments that touch are one.
[[nodiscard]] std::vector<TableSpan> spansOf(const OrbitSegments& segments);

}  // namespace boresight::tables
