// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/passes/pass_book.h"

#include <vector>

namespace boresight::ui {

struct PathPoint
{
    UtcTime utc{};
    SkyPointing direction{};
    bool isHidden = false;  // by the limits of the mount
};

// A pass from its rise to its set, with a point at each whole minute, or each hour of a long one (isMark). Pure.
struct PassPath
{
    std::vector<PathPoint> points;
    std::vector<PathPoint> marks;
};

[[nodiscard]] PassPath pathOf(const BookedPass& one, const PassBook& book);

}  // namespace boresight::ui
