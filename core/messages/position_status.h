// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/units/site.h"
#include "core/units/sky.h"

#include <QString>

#include <cstdint>
#include <optional>

// The balloon or rocket that reports its position, and whether the mount follows it. Plain values.
namespace boresight {

enum class PositionPhase
{
    Off,
    Following,
    Stale  // the mount stands still until a position arrives
};

struct PositionStatus
{
    QString source = {};   // "UDP 127.0.0.1:55673"; empty: the profile names none
    QString name = {};     // call sign of the balloon or rocket; empty: not reported
    QString problem = {};  // why it cannot be tracked now; empty: it can
    QString trouble = {};  // the problem of the port or the broker; empty: none
    std::optional<Site> place = {};
    std::optional<Seconds> age = {};
    std::optional<SkyPointing> direction = {};  // now, also below the horizon
    std::optional<double> kilometres = {};
    std::uint64_t accepted = 0;
    std::uint64_t refused = 0;
    QString refusal = {};  // the reason of the last refusal
    PositionPhase phase = PositionPhase::Off;
};

}  // namespace boresight
