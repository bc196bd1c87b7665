// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/axis_tilt.h"
#include "core/messages/calibration_status.h"
#include "core/pointing/permitted_region.h"
#include "core/tracking/axis_setpoints.h"

#include <vector>

// Where a compass swing turns: the free part of the circle around the boom at its present elevation, once there and
// once back, never past a soft limit. Pure.
namespace boresight {

struct SwingWish
{
    AngularRate rate = AngularRate::fromDegrees(3.0);
    int headings = 0;  // stops each way; 0: a sweep

    bool operator==(const SwingWish&) const = default;
};

// Time at each heading: a reading that is a mean over a second settles, then as many readings follow.
inline constexpr Seconds kSwingDwell{5.0};

[[nodiscard]] SwingPlan planSwing(const SwingWish& wish, const AxisPosition& here,
                                  const pointing::PermittedRegion& region, const tracking::MotionLimits& limits);

// The elevations at which the tilt can be read: not higher than a swing turns.
[[nodiscard]] calibration::LevelLimits levelLimits();

// Why a compass on the boom is of no use at this elevation of the boom. Empty: it can be used.
[[nodiscard]] QString compassObstacle(Angle elevation);

// The azimuths to stop at, first there, then back.
[[nodiscard]] std::vector<Angle> stopsOf(const SwingPlan& plan);

// How far an axis still runs at this rate until it stands.
[[nodiscard]] Angle stoppingWay(AngularRate rate, const tracking::MotionLimits& limits);

}  // namespace boresight
