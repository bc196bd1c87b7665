// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/axis_tilt.h"
#include "core/messages/calibration_status.h"
#include "core/pointing/permitted_region.h"
#include "core/tracking/axis_profile.h"

#include <vector>

// Where a compass swing turns: as much of the circle as is free around the boom at the elevation at which it stands,
// once there and once back, never past a limit of operation. Pure.
namespace boresight {

struct SwingWish
{
    AngularRate rate = AngularRate::fromDegrees(3.0);
    int headings = 0;  // stops each way; 0: a sweep

    bool operator==(const SwingWish&) const = default;
};

// What is asked of one heading: the settling of a reading that is a mean over a second, then as many readings.
inline constexpr Seconds kSwingDwell{5.0};

[[nodiscard]] SwingPlan planSwing(const SwingWish& wish, const AxisPosition& here,
                                  const pointing::PermittedRegion& region, const tracking::MotionLimits& limits);

// Where the tilt is read: no higher than a swing turns at all.
[[nodiscard]] calibration::LevelLimits levelLimits();

// Why a compass on the boom is of no use with the boom at this elevation; empty: it is.
[[nodiscard]] QString compassObstacle(Angle elevation);

// The azimuths to stop at: there, then back.
[[nodiscard]] std::vector<Angle> stopsOf(const SwingPlan& plan);

// How far an axis still runs at this rate until it stands.
[[nodiscard]] Angle stoppingWay(AngularRate rate, const tracking::MotionLimits& limits);

}  // namespace boresight
