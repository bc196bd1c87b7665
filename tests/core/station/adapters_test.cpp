// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/adapters.h"

#include "tests/fakes/text_of.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <gmock/gmock.h>

namespace boresight {
namespace {

using testing::ElementsAre;
using testing::Field;

const SerialPortFacts kFdcanusb{.device = QStringLiteral("/dev/ttyACM1"),
                                .stableName = QStringLiteral("/dev/serial/by-id/usb-mjbots_fdcanusb_1A2B-if00"),
                                .manufacturer = QStringLiteral("mjbots"),
                                .description = QStringLiteral("fdcanusb"),
                                .serialNumber = QStringLiteral("1A2B"),
                                .vendor = 0x0483,
                                .product = 0x5740};
const SerialPortFacts kRadio{.device = QStringLiteral("/dev/ttyUSB0"),
                             .stableName = QStringLiteral("/dev/serial/by-id/usb-FTDI_FT232R-if00"),
                             .manufacturer = QStringLiteral("FTDI"),
                             .description = QStringLiteral("FT232R USB UART"),
                             .serialNumber = {},
                             .vendor = 0x0403,
                             .product = 0x6001};

std::vector<QString> busesOf(const std::vector<Adapter>& adapters)
{
    std::vector<QString> buses;
    std::ranges::transform(adapters, std::back_inserter(buses), &Adapter::bus);
    return buses;
}

// REQ-CAN-21 (Adapters.*): The adapters of this computer are listed under their stable names. Those made for the drives
// come first.
TEST(Adapters, WhatIsMadeForTheDrivesComesFirstAndTheSimulatedMountIsAlwaysThere)
{
    EXPECT_THAT(
        busesOf(adaptersOf({kRadio, kFdcanusb}, {{QStringLiteral("can0"), true}})),
        ElementsAre(QStringLiteral("fdcanusb:/dev/serial/by-id/usb-mjbots_fdcanusb_1A2B-if00"),
                    QStringLiteral("socketcan:can0"), QStringLiteral("fdcanusb:/dev/serial/by-id/usb-FTDI_FT232R-if00"),
                    QStringLiteral("simulated")));
    EXPECT_THAT(busesOf(adaptersOf({}, {})), ElementsAre(QStringLiteral("simulated")));
}

TEST(Adapters, AreCalledAsTheyCallThemselves)
{
    const auto all = adaptersOf({kRadio, kFdcanusb}, {{QStringLiteral("can0"), false}});
    EXPECT_EQ(all[0].name, QStringLiteral("mjbots fdcanusb"));
    EXPECT_EQ(all[0].detail, QStringLiteral("1A2B, /dev/ttyACM1"));
    EXPECT_TRUE(all[0].recognised);
    EXPECT_EQ(all[1].detail, QStringLiteral("can0, down"));
    EXPECT_EQ(all[2].name, QStringLiteral("FTDI FT232R USB UART"));
    EXPECT_FALSE(all[2].recognised);
}

TEST(Adapters, AnAdapterIsKnownByItsNumbersToo)
{
    SerialPortFacts mjcanfd{.device = QStringLiteral("/dev/ttyACM0"),
                            .stableName = {},
                            .manufacturer = {},
                            .description = {},
                            .serialNumber = {},
                            .vendor = 0x1209,
                            .product = 0x2323};
    EXPECT_TRUE(adaptersOf({mjcanfd}, {}).front().recognised);
    EXPECT_EQ(adaptersOf({mjcanfd}, {}).front().bus, QStringLiteral("fdcanusb:/dev/ttyACM0"));
    mjcanfd.product = 0x0001;  // many makers share the vendor number
    EXPECT_FALSE(adaptersOf({mjcanfd}, {}).front().recognised);
}

// Story: the operator mistyped a port, and the scan sent its queries to a radio.
// REQ-CAN-24: A scan sends nothing to a USB device that is not known to be an adapter.
TEST(Adapters, AnotherUsbDeviceIsNotScanned)
{
    const auto refused = mayBeScanned(kRadio);
    ASSERT_FALSE(refused.has_value());
    EXPECT_THAT(textOf(refused.error()),
                testing::HasSubstr("/dev/ttyUSB0 is another USB device (0403:6001 FTDI, FT232R"));
    EXPECT_TRUE(mayBeScanned(kFdcanusb).has_value());
    SerialPortFacts nameless = kRadio;
    nameless.vendor = 0x0483;
    nameless.product = 0x5740;
    EXPECT_TRUE(mayBeScanned(nameless).has_value());
    nameless.vendor = 0x1209;
    nameless.product = 0x2323;
    EXPECT_TRUE(mayBeScanned(nameless).has_value());
    nameless.product = 0x0001;
    EXPECT_FALSE(mayBeScanned(nameless).has_value());
}

// The operator names a moteus at a soldered port, a pseudo-terminal of `boresightctl simulate`, or a CAN interface.
// REQ-CAN-24
TEST(Adapters, WhatIsNoUsbDeviceMayBeScanned)
{
    EXPECT_TRUE(mayBeScanned(QStringLiteral("fdcanusb:/dev/ptmx")).has_value());
    EXPECT_TRUE(mayBeScanned(QStringLiteral("fdcanusb:/no/such/port")).has_value());
    EXPECT_TRUE(mayBeScanned(QStringLiteral("socketcan:can0")).has_value());
    EXPECT_TRUE(mayBeScanned(QStringLiteral("simulated")).has_value());
}

// REQ-CAN-1650: A port that is soldered to the board is offered for the control box of a rotator, and never as an
// adapter of drives. An adapter made for drives is not offered for a control box. The serial line of a control box is
// in no list of adapters.
TEST(Adapters, APortThatIsSolderedToTheBoardIsOfferedForABoxOnly)
{
    const SerialPortFacts onBoard{.device = QStringLiteral("/dev/ttyS0"),
                                  .stableName = {},
                                  .manufacturer = {},
                                  .description = {},
                                  .serialNumber = {},
                                  .vendor = {},
                                  .product = {}};
    const auto all = adaptersOf({onBoard, kRadio, kFdcanusb}, {{QStringLiteral("can0"), true}});
    ASSERT_THAT(busesOf(all), ElementsAre(QStringLiteral("fdcanusb:/dev/serial/by-id/usb-mjbots_fdcanusb_1A2B-if00"),
                                          QStringLiteral("socketcan:can0"),
                                          QStringLiteral("fdcanusb:/dev/serial/by-id/usb-FTDI_FT232R-if00"),
                                          QStringLiteral("serial:/dev/ttyS0"), QStringLiteral("simulated")));
    std::vector<bool> hasDrives;
    std::vector<QString> ports;
    std::ranges::transform(all, std::back_inserter(hasDrives), &Adapter::hasDrives);
    std::ranges::transform(all, std::back_inserter(ports), &Adapter::serialPort);
    EXPECT_THAT(hasDrives, ElementsAre(true, true, true, false, true));
    EXPECT_THAT(ports, ElementsAre(QString(), QString(), QStringLiteral("/dev/serial/by-id/usb-FTDI_FT232R-if00"),
                                   QStringLiteral("/dev/ttyS0"), QString()));
}

// REQ-CAN-1650
TEST(Adapters, TheLineToABoxIsNoAdapterOfDrives)
{
    for (const char* const bus : {"serial:/dev/ttyUSB0", "tcp:10.0.0.7:4001", "rotctld:tower:4534"}) {
        EXPECT_FALSE(withNamed({}, QString::fromLatin1(bus)).front().hasDrives) << bus;
    }
    EXPECT_TRUE(withNamed({}, QStringLiteral("fdcanusb:/tmp/adapter")).front().hasDrives);
}

class NetFolder : public testing::Test
{
protected:
    void add(const QString& name, const QByteArray& type, const QByteArray& flags)
    {
        ASSERT_TRUE(QDir(folder.path()).mkpath(name));
        write(name + QStringLiteral("/type"), type);
        write(name + QStringLiteral("/flags"), flags);
    }
    void write(const QString& path, const QByteArray& text)
    {
        QFile file(folder.filePath(path));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(text);
    }

    QTemporaryDir folder;
};

// REQ-CAN-21 (NetFolder.*)
TEST_F(NetFolder, ACanInterfaceIsToldByItsTypeAndUpByItsFlags)
{
    add(QStringLiteral("eth0"), "1\n", "0x1003\n");
    add(QStringLiteral("can-mount"), "280\n", "0x40081\n");
    add(QStringLiteral("can1"), "280\n", "0x40080\n");
    const auto found = canInterfacesIn(folder.path());
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].name, QStringLiteral("can-mount"));
    EXPECT_TRUE(found[0].up);
    EXPECT_FALSE(found[1].up);
    EXPECT_TRUE(canInterfacesIn(folder.filePath(QStringLiteral("none"))).empty());
}

TEST(Adapters, TheseOfThisComputerAreFound)
{
    EXPECT_EQ(findAdapters().back().bus, QStringLiteral("simulated"));
}

// REQ-CAN-300: A bus with drives that are simulated by another program is marked as simulated. A bus that the operator
// has named is listed, too.
TEST(Adapters, WhatAProgramMakesIsMarkedAsSimulated)
{
    const auto all = adaptersOf({kFdcanusb}, {{QStringLiteral("can0"), true}, {QStringLiteral("vcan0"), true}});
    for (const Adapter& adapter : all) {
        EXPECT_EQ(adapter.simulated, adapter.bus.contains(QStringLiteral("vcan")) || adapter.bus == u"simulated")
            << adapter.bus.toStdString();
    }
    EXPECT_FALSE(isSimulatedBus(QStringLiteral("fdcanusb:/dev/null")));
}

// REQ-CAN-300
TEST(Adapters, ABusThatWasNamedIsListedOnce)
{
    const auto found = adaptersOf({}, {{QStringLiteral("can0"), true}});
    EXPECT_EQ(withNamed(found, QStringLiteral("socketcan:can0")), found);
    EXPECT_EQ(withNamed(found, QString()), found);
    const auto more = withNamed(found, QStringLiteral("fdcanusb:/tmp/adapter"));
    ASSERT_EQ(more.size(), found.size() + 1);
    EXPECT_EQ(more.front().bus, QStringLiteral("fdcanusb:/tmp/adapter"));
}

}  // namespace
}  // namespace boresight
