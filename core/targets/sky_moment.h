// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/units/sky.h"

#include <memory>
#include <vector>

namespace boresight::targets {

// A direction and the time at which an object is there.
struct SkyMoment
{
    UtcTime utc{};
    SkyPointing direction{};
    bool isHidden = false;  // by the limits of the mount

    bool operator==(const SkyMoment&) const = default;
};

// In the order of time. Never changed, so threads share it.
using SkyWay = std::shared_ptr<const std::vector<SkyMoment>>;

}  // namespace boresight::targets
