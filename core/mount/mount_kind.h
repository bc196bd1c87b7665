// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mount/entered_place.h"
#include "core/mount/mount_connection.h"
#include "core/mount/simulation.h"
#include "core/profile/profile.h"
#include "core/units/sky.h"

#include <QString>

#include <functional>
#include <optional>

// One kind of rotator, as the wiring lists them.
namespace boresight {

struct MountStart
{
    QString stateDir;  // of what the mount keeps for the next start
    Simulation simulation = Simulation::Off;
    // Where the mount stood when the operator looked, for drives that do not know it. Counts once, for ten minutes.
    std::optional<EnteredPlace> standingAt{};
    AxisSet axes = kAxes;  // that this mount turns
};

// Makes the mounts of this kind for one program, one after the other. What is simulated stays the same: after a
// reconnect it stands where it stood. Main thread only.
using MountKind = std::function<MountMaker(const profile::Profile& profile, const MountStart& start)>;

}  // namespace boresight
