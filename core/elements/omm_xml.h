// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/elements/element_list.h"

#include <string_view>

// Orbit mean-elements messages as XML (omm_record.h has their fields): every <omm> below any root. A broken end of the
// text does not affect the records before it. Pure.
namespace boresight::orbit {

[[nodiscard]] ElementList readOmmXml(std::string_view text);

}  // namespace boresight::orbit
