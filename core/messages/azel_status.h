// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/units/sky.h"

#include <QString>

#include <optional>

// The state of azel.dat, the file by which WSJT-X reports the Moon, and whether the mount follows that Moon.
namespace boresight {

// What the mount does while it tracks the Moon of WSJT-X.
enum class AzelPhase
{
    Off,
    Following,
    Transmitting,  // the mount stands still until the radio receives
    Stale,         // the mount stands still until the file is written again
    BelowHorizon   // the mount is parked, or on its way to the park position
};

struct AzelStatus
{
    QString path;
    QString problem;                  // why the file cannot be used now; empty: it can
    std::optional<Seconds> age;       // since the time in the file last changed, else since the file was written
    std::optional<SkyPointing> moon;  // as in the file, also below the horizon
    std::optional<Angle> apart;       // from `moon` to the computed Moon; empty: the site is not set
    bool interpolates = false;        // the computed Moon is used, because it agrees with the file
    std::optional<bool> transmits;    // empty: the file has no flag
    AzelPhase phase = AzelPhase::Off;
    std::optional<UtcTime> next = {};  // the next moonset or moonrise, while the Moon is tracked
};

}  // namespace boresight
