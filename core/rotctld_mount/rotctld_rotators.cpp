// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotctld_mount/rotctld_rotators.h"

#include "core/base/bus_name.h"
#include "core/base/text.h"
#include "core/rotator_box/box_connection.h"
#include "core/rotator_box/simulated_box_line.h"
#include "core/rotator_box/tcp_box_line.h"
#include "core/rotctld_mount/hamlib_line.h"
#include "core/rotctld_mount/rotctld_box.h"
#include "core/rotctld_mount/rotctld_mount.h"

namespace boresight::rotctl {
namespace {

// The line for a profile that has passed its checks.
std::unique_ptr<BoxLine> lineOf(const profile::Profile& profile)
{
    const BusName bus = parseBusName(profile.bus).value_or(BusName{});
    if (bus.kind == BusKind::Hamlib) {
        return std::make_unique<HamlibLine>(
            HamlibRotator{.bus = bus, .baud = profile.baud, .settings = profile.hamlibSettings});
    }
    return std::make_unique<TcpBoxLine>(bus);
}

}  // namespace

MountKind rotctldRotators()
{
    return [box = std::make_shared<RotctldBox>()](const profile::Profile& profile, const MountStart& start) {
        std::unique_ptr<BoxLine> line = start.simulation.on ? std::make_unique<SimulatedBoxLine>(box) : lineOf(profile);
        return rotatorBehind<RotctldMount>(std::move(line), start);
    };
}

RotatorOffer rotctldOffer()
{
    constexpr int kPort = 4533;  // port of a rotctld without -t, and usually of Boresight itself
    constexpr int kBeside = kPort + 1;
    return {
        .driver = profile::AxisDriver::Rotctld,
        .name = Text::tr("Any rotator that Hamlib drives, by a rotctld"),
        .place = Text::tr("Address"),
        .placeHelp = Text::tr("HOST:PORT of rotctld. 127.0.0.1 is this computer. Without a port it is %1").arg(kPort),
        .example = QStringLiteral("192.168.1.20:%1").arg(kPort),
        .usualPlaces = {QStringLiteral("127.0.0.1:%1").arg(kBeside)},
        .network = "rotctld",
        .usualPort = kPort,
        .promise =
            {Text::tr("rotctld runs on the computer that has the cable of the rotator. "
                      "Example: rotctld -m 901 -r /dev/ttyUSB0"),
             Text::tr("On this computer use the option -t %1. Boresight itself uses %2.").arg(kBeside).arg(kPort),
             Text::tr("Connect asks rotctld for the limits and for the position. Nothing moves."),
             Text::tr("A server of another kind is asked one question and left alone.")},
        .checks = {Text::tr("Check that rotctld runs on that computer, and that its rotator has power."),
                   Text::tr("Compare the port with the option -t of rotctld. Without -t it is %1.").arg(kPort),
                   Text::tr("From another computer: start rotctld with -T 0.0.0.0, and open its port in the "
                            "firewall.")}};
}

RotatorOffer hamlibOffer()
{
    return {.driver = profile::AxisDriver::Rotctld,
            .name = Text::tr("A rotator from Hamlib's list, at this computer"),
            .hasModels = true,
            .place = Text::tr("Port"),
            .placeHelp = Text::tr("The serial port of the rotator, such as /dev/ttyUSB0, or HOST:PORT for a model that "
                                  "has a network connection"),
            .example = QStringLiteral("/dev/ttyUSB0"),
            .onSerialPort = true,
            .network = "hamlib",
            .promise = {Text::tr("Boresight starts rotctld for this model, and ends it."),
                        Text::tr("Connect asks rotctld for the limits and for the position. Nothing moves. "
                                 "For some models rotctld sends a greeting to the box."),
                        Text::tr("Choose exactly the model that is on the port. Hamlib does not check it.")},
            .checks = {Text::tr("Check the power of the rotator, and the cable."),
                       Text::tr("Compare the model and the speed with the manual of the rotator."),
                       Text::tr("End other programs that use the port.")}};
}

}  // namespace boresight::rotctl
