// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/messages/adapter.h"

#include <QString>

#include <cstdint>
#include <optional>
#include <vector>

// Finds everything on this computer that a mount may be reached by. A serial port is offered under the name that stays
// the same wherever it is plugged in.
namespace boresight {

struct SerialPortFacts
{
    QString device;      // "/dev/ttyACM0"
    QString stableName;  // "/dev/serial/by-id/…"; empty: udev keeps none
    QString manufacturer;
    QString description;
    QString serialNumber;
    std::optional<std::uint16_t> vendor;  // of USB; empty: soldered to the board
    std::optional<std::uint16_t> product;
};

struct CanInterfaceFacts
{
    QString name;  // "can0"
    bool up = false;
};

// Recognised ones first, then CAN interfaces, then other serial ports, those of USB first, then the simulated mount.
[[nodiscard]] std::vector<Adapter> adaptersOf(const std::vector<SerialPortFacts>& ports,
                                              const std::vector<CanInterfaceFacts>& interfaces);

// Those of this computer, now. Reads files of the kernel: some milliseconds, not on the gui thread.
// A bus whose drives a program makes: the built-in mount, a pseudo-terminal, a virtual CAN interface.
[[nodiscard]] bool isSimulatedBus(const QString& bus);
// And the bus that somebody has named, if it is none of them.
[[nodiscard]] std::vector<Adapter> withNamed(std::vector<Adapter> found, const QString& bus);
[[nodiscard]] std::vector<Adapter> findAdapters();

// Whether a scan may write to this port. Not to another USB device: it takes our lines for its own commands. The bus of
// a profile is the operator's choice and is not asked for here.
[[nodiscard]] Result<> mayBeScanned(const SerialPortFacts& port);
// The same for a bus of this computer by its name. Reads files of the kernel: some milliseconds.
[[nodiscard]] Result<> mayBeScanned(const QString& bus);

// The CAN interfaces in such a folder: /sys/class/net.
[[nodiscard]] std::vector<CanInterfaceFacts> canInterfacesIn(const QString& folder);

}  // namespace boresight
