// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/elements/element_list.h"

#include <string_view>

// Element sets in the files of Gpredict: a key file with one group for each satellite, with NAME, TLE1 and TLE2. A file
// NUMBER.sat in its folder satdata has one group [Satellite]. The satellites.dat that comes with Gpredict has a group
// [NUMBER] for each satellite. Pure.
namespace boresight::orbit {

[[nodiscard]] ElementList readSatdata(std::string_view text);

}  // namespace boresight::orbit
