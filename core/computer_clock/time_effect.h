// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <functional>
#include <optional>

// What changes for the mount if the clock of the station is set by some seconds. Pure.
namespace boresight {

struct TimeEffect
{
    bool moves = false;   // a target that is up is tracked by the time, so the mount would jump
    bool delays = false;  // the rise of a target or a pass of the schedule would come at another time
    QString shift = {};   // for a mount that would jump: "ISS (ZARYA) would be 99.0° away"

    [[nodiscard]] bool isAny() const { return moves || delays; }
    bool operator==(const TimeEffect&) const = default;
};

// The direction of the tracked target at a time. Empty: unknown.
using TargetAt = std::function<std::optional<SkyPointing>(UtcTime)>;

[[nodiscard]] TimeEffect timeEffect(const StationStatus& status, const TargetAt& targetAt, Seconds by);

}  // namespace boresight
