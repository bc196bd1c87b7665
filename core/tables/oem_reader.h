// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tables/table.h"
#include "core/tables/table_problem.h"

#include <string>
#include <string_view>

// Reads orbit ephemeris messages in KVN form: CCSDS 502.0-B, section 5. Only one object, and only around the Earth.
// Accelerations, covariances and comments are ignored. Pure.
namespace boresight::tables {

struct Oem
{
    std::string name;  // of the object; printable, may be empty
    OrbitSegments segments;
};

// The first word of every OEM in KVN form.
inline constexpr std::string_view kOemStart = "CCSDS_OEM_VERS";

[[nodiscard]] TableReading<Oem> readOem(std::string_view text);

// The usable times. Adjacent segments are joined.
[[nodiscard]] std::vector<TableSpan> spansOf(const OrbitSegments& segments);

}  // namespace boresight::tables
