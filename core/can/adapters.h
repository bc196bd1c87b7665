// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <QMetaType>
#include <QString>

#include <cstdint>
#include <optional>
#include <vector>

// Everything on this computer that a mount may be reached by, with the names that people and profiles use. A serial
// port is offered under the name that stays the same wherever it is plugged in.
namespace boresight {

struct Adapter
{
    QString bus;              // as a profile names it: "fdcanusb:/dev/serial/by-id/usb-mjbots_fdcanusb_1A2B-if00"
    QString name;             // as it calls itself: "mjbots fdcanusb"
    QString detail;           // serial number, port: what tells two of a kind apart
    bool recognised = false;  // made for these drives; else it may be something else altogether

    bool operator==(const Adapter&) const = default;
};

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

// Recognised ones first, then CAN interfaces, then other serial ports of USB, then the simulated mount.
[[nodiscard]] std::vector<Adapter> adaptersOf(const std::vector<SerialPortFacts>& ports,
                                              const std::vector<CanInterfaceFacts>& interfaces);

// Those of this computer, now. Reads files of the kernel: some milliseconds, not on the gui thread.
[[nodiscard]] std::vector<Adapter> findAdapters();

// Whether a scan may write to this port. Not to another USB device: it takes our lines for its own commands. The bus of
// a profile is the operator's choice and is not asked for here.
[[nodiscard]] Result<> mayBeScanned(const SerialPortFacts& port);
// The same for a bus of this computer by its name. Reads files of the kernel: some milliseconds.
[[nodiscard]] Result<> mayBeScanned(const QString& bus);

// The CAN interfaces in such a folder: /sys/class/net.
[[nodiscard]] std::vector<CanInterfaceFacts> canInterfacesIn(const QString& folder);

}  // namespace boresight

Q_DECLARE_METATYPE(std::vector<boresight::Adapter>)
