// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/elements/element_list.h"

#include <string_view>

// Orbit mean-elements messages as JSON (omm_record.h has their fields): an array of objects, or one object. Numbers may
// be strings. A broken object does not affect the others. Pure.
namespace boresight::orbit {

[[nodiscard]] ElementList readOmmJson(std::string_view text);

}  // namespace boresight::orbit
