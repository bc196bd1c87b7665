// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/messages/adapter.h"

#include <QString>

#include <cstdint>
#include <optional>
#include <vector>

// Finds every port and bus of this computer that can lead to a mount. A serial port is offered under a name that stays
// the same in every USB socket.
namespace boresight {

struct SerialPortFacts
{
    QString device;      // "/dev/ttyACM0"
    QString stableName;  // "/dev/serial/by-id/…"; empty: udev has no such name
    QString manufacturer;
    QString description;
    QString serialNumber;
    std::optional<std::uint16_t> vendor;  // USB vendor id; empty: a port on the mainboard
    std::optional<std::uint16_t> product;
};

struct CanInterfaceFacts
{
    QString name;  // "can0"
    bool up = false;
};

// In this order: recognised serial ports, CAN interfaces, other USB ports, ports on the mainboard, simulated mount.
[[nodiscard]] std::vector<Adapter> adaptersOf(const std::vector<SerialPortFacts>& ports,
                                              const std::vector<CanInterfaceFacts>& interfaces);

// Whether the drives of a bus are simulated: the built-in mount, a pseudo-terminal, a virtual CAN interface.
[[nodiscard]] bool isSimulatedBus(const QString& bus);
// Adds the bus that the command line or the profile names, if it is not among them.
[[nodiscard]] std::vector<Adapter> withNamed(std::vector<Adapter> found, const QString& bus);
// The adapters that this computer has now. Reads files of the kernel for some milliseconds: not on the gui thread.
[[nodiscard]] std::vector<Adapter> findAdapters();

// Whether a scan may write to this port. Another kind of USB device could take the lines for its own commands. The bus
// of a profile is the choice of the operator and is not checked here.
[[nodiscard]] Result<> mayBeScanned(const SerialPortFacts& port);
// The same for a bus of this computer by its name. Reads files of the kernel for some milliseconds.
[[nodiscard]] Result<> mayBeScanned(const QString& bus);

// The CAN interfaces in a folder like /sys/class/net.
[[nodiscard]] std::vector<CanInterfaceFacts> canInterfacesIn(const QString& folder);

}  // namespace boresight
