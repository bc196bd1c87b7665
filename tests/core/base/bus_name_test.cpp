// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/bus_name.h"

#include "tests/fakes/text_of.h"

#include <gmock/gmock.h>

namespace boresight {
namespace {

// REQ-BASE-06 (BusName.*): The profile, the command line and the tools read bus names in the same way.
TEST(BusName, ReadsTheThreeKindsAndWritesThemBack)
{
    EXPECT_EQ(parseBusName("simulated"), (BusName{BusKind::Simulated, {}}));
    EXPECT_EQ(parseBusName("socketcan:can0"), (BusName{BusKind::SocketCan, "can0"}));
    EXPECT_EQ(parseBusName("fdcanusb:/dev/ttyACM0"), (BusName{BusKind::Fdcanusb, "/dev/ttyACM0"}));
    EXPECT_EQ(parseBusName("fdcanusb:C:odd"), (BusName{BusKind::Fdcanusb, "C:odd"}));
    EXPECT_EQ(parseBusName("serial:/dev/ttyUSB0"), (BusName{BusKind::Serial, "/dev/ttyUSB0"}));
    EXPECT_EQ(parseBusName("tcp:rotator.local:4001"), (BusName{BusKind::Tcp, "rotator.local", 4001}));
    EXPECT_EQ(parseBusName("rotctld:10.0.0.7:4533"), (BusName{BusKind::Rotctld, "10.0.0.7", 4533}));
    EXPECT_EQ(parseBusName("hamlib:901:/dev/ttyUSB0"), (BusName{BusKind::Hamlib, "/dev/ttyUSB0", 0, 901}));
    EXPECT_EQ(parseBusName("hamlib:2402:10.0.0.7:23"), (BusName{BusKind::Hamlib, "10.0.0.7:23", 0, 2402}));
    EXPECT_EQ(parseBusName("hamlib:1"), (BusName{BusKind::Hamlib, {}, 0, 1}));
    EXPECT_EQ(parseBusName("tcp:[fe80::1]:1"), (BusName{BusKind::Tcp, "fe80::1", 1}));
    for (const char* const name : {"simulated", "socketcan:vcan12", "fdcanusb:/dev/boresight/fdcanusb",
                                   "serial:/dev/ttyS0", "tcp:10.0.0.7:65535", "tcp:[::1]:4001", "rotctld:[::1]:4533",
                                   "hamlib:1", "hamlib:603:/dev/serial/by-path/pci-0000:00:14.0-usb-0:1:1.0-port0"}) {
        EXPECT_EQ(toString(parseBusName(name).value()), name);
    }
}

TEST(BusName, RefusesWithWhatToWrite)
{
    EXPECT_THAT(textOf(parseBusName("can0").error()), testing::HasSubstr("'can0'"));
    EXPECT_THAT(textOf(parseBusName("can0").error()), testing::HasSubstr("socketcan:INTERFACE"));
    EXPECT_THAT(textOf(parseBusName("socketcan:").error()), testing::HasSubstr("names no interface"));
    EXPECT_THAT(textOf(parseBusName("fdcanusb:").error()), testing::HasSubstr("names no port"));
    EXPECT_THAT(textOf(parseBusName("rotctld:pi").error()), testing::HasSubstr("rotctld:192.168.1.20:4533"));
    EXPECT_THAT(textOf(parseBusName("hamlib:SPID").error()), testing::HasSubstr("hamlib:901:/dev/ttyUSB0"));
    for (const char* const bad : {"",
                                  "simulated ",
                                  "Simulated",
                                  "simulated:x",
                                  "socketcan:can 0",
                                  "socketcan:a/b",
                                  "socketcan:sixteen-letters0",
                                  "socketcan",
                                  "fdcanusb:/dev/a\nb",
                                  "socketcan:a\nb",
                                  "socketcan:\x7f",
                                  "fdcanusb:/dev/a\x7f",
                                  "serial:",
                                  "serial:/dev/a\nb",
                                  "tcp:",
                                  "tcp:a",
                                  "tcp::1",
                                  "tcp:a:0",
                                  "tcp:a:65536",
                                  "tcp:a:-1",
                                  "tcp:a:x",
                                  "tcp:a b:1",
                                  "tcp:::1:4001",
                                  "tcp:[a]:1",
                                  "rotctld:",
                                  "rotctld:a",
                                  "rotctld:a:0",
                                  "hamlib:",
                                  "hamlib:603:",
                                  "hamlib:0:/dev/ttyUSB0",
                                  "hamlib:-1:/dev/ttyUSB0",
                                  "hamlib:100000:/dev/ttyUSB0",
                                  "hamlib:/dev/ttyUSB0",
                                  "hamlib:SPID:/dev/ttyUSB0",
                                  "hamlib:603:/dev/a\nb"}) {
        const auto result = parseBusName(bad);
        ASSERT_FALSE(result.has_value()) << bad;
        EXPECT_EQ(result.error().code, ErrorCode::InvalidInput) << bad;
    }
}

}  // namespace
}  // namespace boresight
