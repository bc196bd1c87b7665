// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/elements/element_list.h"

#include <string_view>

// Orbit mean-elements messages as CSV (omm_record.h has their fields). A header line names the columns. Values may be
// in double quotes. Pure.
namespace boresight::orbit {

[[nodiscard]] ElementList readOmmCsv(std::string_view text);

}  // namespace boresight::orbit
