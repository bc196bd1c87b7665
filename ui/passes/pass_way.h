// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/targets/sky_moment.h"
#include "ui/passes/pass_book.h"

namespace boresight::ui {

// Of a pass, from its rise to its set. Pure.
[[nodiscard]] targets::SkyWay wayOf(const BookedPass& one, const PassBook& book);

}  // namespace boresight::ui
