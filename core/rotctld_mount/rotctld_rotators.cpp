// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotctld_mount/rotctld_rotators.h"

#include "core/base/bus_name.h"
#include "core/rotator_box/box_connection.h"
#include "core/rotator_box/simulated_box_line.h"
#include "core/rotator_box/tcp_box_line.h"
#include "core/rotctld_mount/rotctld_box.h"
#include "core/rotctld_mount/rotctld_mount.h"

namespace boresight::rotctl {
namespace {

// What the checks of the profile have let through. A rotctld that we start ourselves will be another line here.
std::unique_ptr<BoxLine> lineOf(const profile::Profile& profile)
{
    return std::make_unique<TcpBoxLine>(parseBusName(profile.bus).value_or(BusName{}));
}

}  // namespace

MountKind rotctldRotators()
{
    return [box = std::make_shared<RotctldBox>()](const profile::Profile& profile, const MountStart& start) {
        std::unique_ptr<BoxLine> line = start.simulation.on ? std::make_unique<SimulatedBoxLine>(box) : lineOf(profile);
        return rotatorBehind<RotctldMount>(std::move(line), start);
    };
}

}  // namespace boresight::rotctl
