// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/elements/element_list.h"

#include <string_view>

// Orbit mean-elements messages as KVN (omm_record.h has their fields): lines KEY = value, optionally with a unit in
// brackets. A record begins with CCSDS_OMM_VERS, or where a key occurs again. Pure.
namespace boresight::orbit {

[[nodiscard]] ElementList readOmmKvn(std::string_view text);

}  // namespace boresight::orbit
