// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/adapters.h"

#include "core/base/bus_name.h"
#include "core/base/text.h"
#include "core/can/adapter_port.h"
#include "core/can/bit_timing.h"
#include "core/serial/serial_port_check.h"
#include "core/serial/stable_port.h"

#include <QDir>
#include <QFile>
#include <QSerialPortInfo>

#include <algorithm>

namespace boresight {
namespace {

constexpr std::uint16_t kMjbotsVendor = 0x1209;  // of pid.codes, shared by many makers
constexpr std::uint16_t kMjcanfd = 0x2323;       // mjcanfd-usb-1x
constexpr std::uint16_t kStVendor = 0x0483;
constexpr std::uint16_t kFdcanusb = 0x5740;  // used by every serial port that is made with ST's example
constexpr int kTypeOfCan = 280;              // ARPHRD_CAN of linux/if_arp.h
constexpr unsigned kInterfaceUp = 1;         // IFF_UP of linux/if.h

QString joined(const QStringList& parts)
{
    QStringList given = parts;
    given.removeAll(QString());
    return given.join(QStringLiteral(", "));
}

bool isRecognised(const SerialPortFacts& port)
{
    const bool isMjcanfd = port.vendor == kMjbotsVendor && port.product == kMjcanfd;
    return isMjcanfd || isAdapterName(port.stableName) || isAdapterName(port.manufacturer) ||
           isAdapterName(port.description);
}

Adapter serialAdapter(const SerialPortFacts& port)
{
    const QString path = port.stableName.isEmpty() ? port.device : port.stableName;
    QString name = joined({port.manufacturer, port.description}).replace(QStringLiteral(", "), QStringLiteral(" "));
    name.replace(QLatin1Char('_'), QLatin1Char(' '));
    return {.bus = QStringLiteral("fdcanusb:") + path,
            .name = name.isEmpty() ? Text::tr("USB serial port") : name,
            .detail = joined({port.serialNumber, port.device}),
            .recognised = isRecognised(port),
            .serialPort = isRecognised(port) ? QString() : path};
}

// A port on the mainboard can lead to the control box of a rotator, but not to drives.
Adapter boxPort(const SerialPortFacts& port)
{
    return {.bus = QStringLiteral("serial:") + port.device,
            .name = Text::tr("Serial port"),
            .detail = port.device,
            .hasDrives = false,
            .serialPort = port.device};
}

Adapter canAdapter(const CanInterfaceFacts& interface)
{
    return {.bus = QStringLiteral("socketcan:") + interface.name,
            .name = Text::tr("CAN interface"),
            .detail = interface.up ? interface.name : Text::tr("%1, down").arg(interface.name),
            .recognised = true,
            .simulated = socketcan::looksVirtual(interface.name)};
}

QByteArray contents(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll().trimmed() : QByteArray();
}

SerialPortFacts factsOf(const QSerialPortInfo& info)
{
    return {.device = info.systemLocation(),
            .stableName = stableNameOf(info.systemLocation()),
            .manufacturer = info.manufacturer(),
            .description = info.description(),
            .serialNumber = info.serialNumber(),
            .vendor = info.hasVendorIdentifier() ? std::optional(info.vendorIdentifier()) : std::nullopt,
            .product = info.hasProductIdentifier() ? std::optional(info.productIdentifier()) : std::nullopt};
}

std::vector<SerialPortFacts> serialPorts()
{
    std::vector<SerialPortFacts> ports;
    std::ranges::transform(QSerialPortInfo::availablePorts(), std::back_inserter(ports), factsOf);
    return ports;
}

QString fourDigits(std::uint16_t number)
{
    return QStringLiteral("%1").arg(number, 4, 16, QLatin1Char('0'));
}

bool leadsToDrives(BusKind kind)
{
    return kind == BusKind::Simulated || kind == BusKind::SocketCan || kind == BusKind::Fdcanusb;
}

}  // namespace

std::vector<Adapter> adaptersOf(const std::vector<SerialPortFacts>& ports,
                                const std::vector<CanInterfaceFacts>& interfaces)
{
    std::vector<Adapter> all;
    std::vector<Adapter> onBoard;
    for (const SerialPortFacts& port : ports) {
        if (port.vendor || isRecognised(port)) {
            all.push_back(serialAdapter(port));
        } else {
            onBoard.push_back(boxPort(port));
        }
    }
    const auto others = std::ranges::stable_partition(all, &Adapter::recognised);
    std::vector<Adapter> can;
    std::ranges::transform(interfaces, std::back_inserter(can), canAdapter);
    all.insert(others.begin(), can.begin(), can.end());
    all.insert(all.end(), onBoard.begin(), onBoard.end());
    all.push_back({.bus = QStringLiteral("simulated"),
                   .name = Text::tr("Simulated mount"),
                   .detail = Text::tr("built in, needs no hardware"),
                   .recognised = true,
                   .simulated = true});
    return all;
}

bool isSimulatedBus(const QString& bus)
{
    const auto name = parseBusName(bus.toStdString());
    if (!name) {
        return false;
    }
    switch (name->kind) {
        case BusKind::Simulated:
            return true;
        case BusKind::SocketCan:
            return socketcan::looksVirtual(QString::fromStdString(name->target));
        case BusKind::Tcp:
        case BusKind::Rotctld:
        case BusKind::Hamlib:
            return false;
        case BusKind::Fdcanusb:
        case BusKind::Serial:
            break;
    }
    const auto port = portIdentity(QString::fromStdString(name->target));
    return port && isPseudoTerminal(port->device);
}

std::vector<Adapter> withNamed(std::vector<Adapter> found, const QString& bus)
{
    const bool isThere = std::ranges::find(found, bus, &Adapter::bus) != found.end();
    const auto name = parseBusName(bus.toStdString());
    if (!isThere && name) {
        found.insert(found.begin(), {.bus = bus,
                                     .name = bus.section(QLatin1Char(':'), 1),
                                     .detail = Text::tr("named by the command line or the profile"),
                                     .recognised = true,
                                     .simulated = isSimulatedBus(bus),
                                     .hasDrives = leadsToDrives(name->kind)});
    }
    return found;
}

Result<> mayBeScanned(const SerialPortFacts& port)
{
    const bool isFdcanusb = port.vendor == kStVendor && port.product == kFdcanusb;
    if (!port.vendor || isFdcanusb || isRecognised(port)) {
        return {};
    }
    return failure(ErrorCode::Refused,
                   Text::tr("%1 is another USB device (%2:%3 %4). Known adapters are 0483:5740 and 1209:2323. Nothing "
                            "was sent to it. If it is an adapter, enter it as the bus of the profile")
                       .arg(port.device, fourDigits(*port.vendor), fourDigits(port.product.value_or(0)),
                            joined({port.manufacturer, port.description})));
}

Result<> mayBeScanned(const QString& bus)
{
    const auto name = parseBusName(bus.toStdString());
    if (!name || name->kind != BusKind::Fdcanusb) {
        return {};
    }
    const QString port = canonicalPort(QString::fromStdString(name->target));
    return mayBeScanned(factsOf(QSerialPortInfo(port.section(QLatin1Char('/'), -1))));
}

std::vector<CanInterfaceFacts> canInterfacesIn(const QString& folder)
{
    std::vector<CanInterfaceFacts> found;
    const auto names = QDir(folder).entryList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name);
    for (const QString& name : names) {
        const QString own = folder + QLatin1Char('/') + name;
        if (contents(own + QStringLiteral("/type")).toInt() == kTypeOfCan) {
            const unsigned flags = contents(own + QStringLiteral("/flags")).toUInt(nullptr, 0);  // "0x40081"
            found.push_back({.name = name, .up = (flags & kInterfaceUp) != 0});
        }
    }
    return found;
}

std::vector<Adapter> findAdapters()
{
    return adaptersOf(serialPorts(), canInterfacesIn(QStringLiteral("/sys/class/net")));
}

}  // namespace boresight
