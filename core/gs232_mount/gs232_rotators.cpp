// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gs232_mount/gs232_rotators.h"

#include "core/base/bus_name.h"
#include "core/base/text.h"
#include "core/gs232_mount/esp32_box.h"
#include "core/gs232_mount/gs232_box.h"
#include "core/gs232_mount/gs232_mount.h"
#include "core/rotator_box/box_connection.h"
#include "core/rotator_box/serial_box_line.h"
#include "core/rotator_box/simulated_box_line.h"
#include "core/rotator_box/tcp_box_line.h"

namespace boresight::gs232 {
namespace {

// Away from the ends of its travel, because its heading is counted nearest to the middle.
constexpr AxisPosition kStartOfEsp32{.azimuth = 180_deg, .elevation = 20_deg};

// The line for a profile that has passed its checks.
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
    return [box = std::make_shared<Gs232Box>(), esp32 = std::make_shared<Esp32Box>(kStartOfEsp32)](
               const profile::Profile& profile, const MountStart& start) {
        const bool isEsp32 = start.simulation.device == profile::SimulatedDevice::Esp32;
        const std::shared_ptr<SimulatedBox> simulated = isEsp32 ? std::shared_ptr<SimulatedBox>(esp32) : box;
        std::unique_ptr<BoxLine> line =
            start.simulation.on ? std::make_unique<SimulatedBoxLine>(simulated) : lineOf(profile);
        return rotatorBehind<Gs232Mount>(std::move(line), start);
    };
}

RotatorOffer gs232Offer()
{
    return {.driver = profile::AxisDriver::Gs232,
            .name = Text::tr("GS-232 rotator (Yaesu and others), by serial port or network"),
            .place = Text::tr("Port"),
            .placeHelp = Text::tr("A serial port such as /dev/ttyUSB0, or HOST:PORT of a serial server"),
            .example = Text::tr("/dev/ttyUSB0 or 192.168.1.20:4001"),
            .onSerialPort = true,
            .network = "tcp",
            .promise = {Text::tr("The box is a GS-232A, a GS-232B, a compatible box or the ESP32 relay controller."),
                        Text::tr("Connect asks for the position. Nothing moves."),
                        Text::tr("A device of another kind is left alone.")},
            .checks = {Text::tr("Check the power of the box, and the cable."),
                       Text::tr("Compare the speed with the switches of the box."),
                       Text::tr("End other programs that use the port.")}};
}

}  // namespace boresight::gs232
