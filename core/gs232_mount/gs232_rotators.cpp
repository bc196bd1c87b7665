// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gs232_mount/gs232_rotators.h"

#include "core/base/bus_name.h"
#include "core/gs232_mount/gs232_box.h"
#include "core/gs232_mount/gs232_mount.h"
#include "core/rotator_box/box_connection.h"
#include "core/rotator_box/serial_box_line.h"
#include "core/rotator_box/simulated_box_line.h"
#include "core/rotator_box/tcp_box_line.h"

namespace boresight::gs232 {
namespace {

// What the checks of the profile have let through.
std::unique_ptr<BoxLine> lineOf(const profile::Profile& profile)
{
    const auto bus = parseBusName(profile.bus);
    if (bus && bus->kind == BusKind::Tcp) {
        return std::make_unique<TcpBoxLine>(*bus);
    }
    return std::make_unique<SerialBoxLine>(bus ? QString::fromStdString(bus->target) : QString(), profile.baud);
}

}  // namespace

MountKind gs232Rotators()
{
    return [box = std::make_shared<Gs232Box>()](const profile::Profile& profile, const MountStart& start) {
        std::unique_ptr<BoxLine> line = start.simulation.on ? std::make_unique<SimulatedBoxLine>(box) : lineOf(profile);
        return rotatorBehind<Gs232Mount>(std::move(line), start);
    };
}

}  // namespace boresight::gs232
