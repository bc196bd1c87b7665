// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tables/oem_reader.h"

// Reads orbit ephemeris messages in XML form: CCSDS 502.0-B and 505.0-B, alone or inside <ndm>. The same content is
// read and refused as in the KVN form. Pure.
namespace boresight::tables {

[[nodiscard]] TableReading<Oem> readOemXml(std::string_view text);

}  // namespace boresight::tables
