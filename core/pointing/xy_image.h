// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pointing/axis_box.h"
#include "core/pointing/region.h"
#include "core/pointing/skyline.h"

#include <vector>

// Horizon and keep-outs are true directions. This class converts them into the angles X and Y that are forbidden on an
// X/Y mount. Straight edges on the sky are curves in X and Y, so boxes enclose each shape like steps. Nothing forbidden
// is lost, and little more is forbidden: on the sky at most 2° beside an edge (METHOD.md). Pure values, any thread.
namespace boresight::pointing {

class XYImage
{
public:
    // `ranges` are those of X and Y within travel and limits. X counts within ±180° and Y within ±90°. `xAxis` is the
    // azimuth of the X axis.
    XYImage(const AxisBox& ranges, Angle xAxis);

    // Everything below the horizon.
    [[nodiscard]] std::vector<AxisBox> of(const Skyline& horizon) const;
    // All of these keep-outs together.
    [[nodiscard]] std::vector<AxisBox> of(const std::vector<KeepOut>& keepOuts) const;

private:
    AxisBox m_ranges;
    Angle m_xAxis;
};

}  // namespace boresight::pointing
