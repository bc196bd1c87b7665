// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/units/sky.h"

#include <QString>

#include <optional>

// What is known of the azel.dat by which WSJT-X reports the Moon, and whether the mount follows it.
namespace boresight {

// What the mount does about the Moon of WSJT-X.
enum class AzelPhase
{
    Off,
    Following,
    Transmitting,  // it stands still until the radio receives
    Stale,         // it stands still until the file is written again
    BelowHorizon   // it is parked, or on its way there
};

struct AzelStatus
{
    QString path;
    QString problem;                  // why it cannot be steered by now; empty: it can
    std::optional<Seconds> age;       // since its time was seen to change, else since it was written
    std::optional<SkyPointing> moon;  // as the file has it; also below the horizon
    std::optional<Angle> apart;       // of that from our own Moon; empty: the site is not set
    bool interpolates = false;        // our own Moon stands for the file's, because both agree
    std::optional<bool> transmits;    // empty: the file has no flag
    AzelPhase phase = AzelPhase::Off;
    std::optional<UtcTime> next = {};  // the Moon sets, or rises; known while it is followed
};

}  // namespace boresight
