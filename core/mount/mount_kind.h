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

// One kind of rotator, as the list of mount kinds has it.
namespace boresight {

struct MountStart
{
    QString stateDir;  // folder of the files that the mount stores for the next start
    Simulation simulation = Simulation::Off;
    // Where the mount was when the operator looked, for drives that do not know it. Used once, and only for ten
    // minutes.
    std::optional<EnteredPlace> standingAt{};
    AxisSet axes = kAxes;  // the axes that this mount turns
};

// Makes the mounts of this kind for one program, one after the other. A simulated mount stays the same: after a
// reconnect it is where it was. Main thread only.
using MountKind = std::function<MountMaker(const profile::Profile& profile, const MountStart& start)>;

}  // namespace boresight
