// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tables/oem_reader.h"

// Orbit ephemeris messages as XML: CCSDS 502.0-B and 505.0-B, alone or inside <ndm>. What is read and what is refused
// is that of the KVN form. Pure.
namespace boresight::tables {

[[nodiscard]] TableReading<Oem> readOemXml(std::string_view text);

}  // namespace boresight::tables
