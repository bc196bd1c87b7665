// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/elements/element_list.h"

#include <string_view>

// Element sets as Gpredict keeps them: a key file with a group for each satellite, with NAME, TLE1 and TLE2. There is
// one [Satellite] in NUMBER.sat of its folder satdata, and a [NUMBER] for each in the satellites.dat that it comes
// with. Pure.
namespace boresight::orbit {

[[nodiscard]] ElementList readSatdata(std::string_view text);

}  // namespace boresight::orbit
