// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"

#include <QString>

#include <cstdint>
#include <optional>

// What is known about the wind, and what it forbids. Plain values.
namespace boresight {

struct WindStatus
{
    QString source = {};                          // "mqtt:shack/wind"; empty: the profile names none
    QString trouble = {};                         // of the port or the broker; empty: none
    std::optional<double> speed = {};             // m/s, of the last reading
    Seconds age{0.0};                             // of the last reading; without one: since readings are expected
    bool isSilent = false;                        // no reading for too long, so `speed` is out of date
    QString obstacle = {};                        // why only Park may move the mount; empty: the wind forbids nothing
    std::optional<UtcTime> overriddenUntil = {};  // until then the operator may move the mount in a strong wind
    std::uint64_t accepted = 0;
    std::uint64_t refused = 0;
    QString refusal = {};  // reason of the last refusal
};

}  // namespace boresight
