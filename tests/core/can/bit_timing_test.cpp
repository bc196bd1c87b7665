// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/can/bit_timing.h"

#include "core/base/hex.h"
#include "core/can/bus_advice.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <bit>
#include <iterator>

namespace boresight::socketcan {
namespace {

using testing::HasSubstr;
using testing::Not;

std::vector<std::uint8_t> bytesOf(std::string_view hex)
{
    std::string digits;
    std::ranges::remove_copy(hex, std::back_inserter(digits), ' ');
    return parseHex(digits).value();
}

// An 80 MHz adapter with the settings for moteus: up, error-active, one lost frame in its counters. Made by hand from
// linux/netlink.h, linux/rtnetlink.h, linux/if_link.h and linux/can/netlink.h, least significant byte first.
constexpr std::string_view kAdapter =
    "dc000000 1000 0000 01000000 00000000"          // nlmsghdr: 220 bytes, RTM_NEWLINK, no flags, sequence 1, port 0
    "00 00 1801 03000000 c1000100 00000000"         // ifinfomsg: any family, ARPHRD_CAN, index 3, up, change 0
    "0900 0300 63616e30 00 000000"                  // IFLA_IFNAME "can0", padded
    "0800 0400 48000000"                            // IFLA_MTU 72
    "a800 1200"                                     // IFLA_LINKINFO, 168 bytes
    "0800 0100 63616e00"                            // . IFLA_INFO_KIND "can"
    "9c00 0200"                                     // . IFLA_INFO_DATA, 156 bytes
    "2400 0100 40420f00 96020000 0c000000"          // .. IFLA_CAN_BITTIMING 1000000 bit/s, 662 per mille, tq 12 ns
    "1a000000 1a000000 1b000000 0a000000 01000000"  //    prop 26, phase1 26, phase2 27, sjw 10, brp 1
    "0800 0300 00b4c404"                            // .. IFLA_CAN_CLOCK 80 MHz
    "0800 0400 00000000"                            // .. IFLA_CAN_STATE error-active
    "0c00 0500 00000000 20000000"                   // .. IFLA_CAN_CTRLMODE mask 0, flags FD
    "0800 0600 e8030000"                            // .. IFLA_CAN_RESTART_MS 1000
    "0800 0800 0800 0100"                           // .. IFLA_CAN_BERR_COUNTER tx 8, rx 1
    "2400 0900 404b4c00 71020000 0c000000"          // .. IFLA_CAN_DATA_BITTIMING 5000000 bit/s, 625 per mille
    "04000000 05000000 06000000 05000000 01000000"  //    prop 4, phase1 5, phase2 6, sjw 5, brp 1
    "2400 ff0f 00000000 00000000 00000000 00000000 00000000 00000000 00000000 00000000";  // .. of a newer kernel

// A virtual interface: down, with a kind, and without data about a controller.
constexpr std::string_view kVirtual =
    "3c000000 1000 0000 01000000 00000000"    // nlmsghdr: 60 bytes
    "00 00 1801 05000000 c0000000 00000000"   // ifinfomsg: index 5, down
    "0a00 0300 7663616e3000 0000"             // IFLA_IFNAME "vcan0"
    "1000 1280 0900 0100 7663616e00 000000";  // IFLA_LINKINFO, marked as nested: kind "vcan"

InterfaceReport adapter()
{
    return {.index = 3,
            .name = "can0",
            .up = true,
            .kind = "can",
            .nominal = PhaseTiming{.bitRate = 1'000'000, .samplePoint = 0.662},
            .data = PhaseTiming{.bitRate = 5'000'000, .samplePoint = 0.625},
            .flexibleData = true,
            .controller = ControllerState::Active,
            .errors = ErrorCounters{.transmit = 8, .receive = 1}};
}

class InterfaceReportTest : public testing::Test
{
protected:
    void SetUp() override
    {
        if (std::endian::native != std::endian::little) {
            GTEST_SKIP() << "the bytes are those of a little-endian machine";
        }
    }
};

// REQ-CAN-15 (InterfaceReportTest.*): A wrong bit rate or sample point, or the classic mode of a real interface, is
// reported with the found and the wanted value and with the commands to correct it. A virtual interface has no timing.
TEST_F(InterfaceReportTest, QuestionNamesTheInterface)
{
    EXPECT_EQ(interfaceQuestion(3, 1), bytesOf("20000000 1200 0100 01000000 00000000"      // RTM_GETLINK, NLM_F_REQUEST
                                               "00 00 0000 03000000 00000000 00000000"));  // index 3
}

TEST_F(InterfaceReportTest, AdapterIsReadWhole)
{
    EXPECT_EQ(readInterfaceAnswer(bytesOf(kAdapter)), adapter());
}

TEST_F(InterfaceReportTest, VirtualInterfaceHasNoTiming)
{
    const auto report = readInterfaceAnswer(bytesOf(kVirtual));
    EXPECT_EQ(report, (InterfaceReport{.index = 5, .name = "vcan0", .up = false, .kind = "vcan"}));
    EXPECT_EQ(timingTrouble(*report), QString());
}

// The message is cut at every length, with and without a corrected length in its header. The result is never half a
// description, and nothing is read beyond the end.
TEST_F(InterfaceReportTest, CutMessageIsRefusedOrLacksWholeAttributes)
{
    const std::vector<std::uint8_t> whole = bytesOf(kAdapter);
    for (std::size_t size = 0; size < whole.size(); ++size) {
        std::vector<std::uint8_t> cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
        EXPECT_FALSE(readInterfaceAnswer(cut).has_value()) << size;
        if (size >= 4) {
            cut[0] = static_cast<std::uint8_t>(size);
            const auto report = readInterfaceAnswer(cut);
            EXPECT_TRUE(!report || (report->kind.empty() && !report->nominal)) << size;
        }
    }
}

TEST_F(InterfaceReportTest, LyingLengthsAreRefused)
{
    const std::vector<std::uint8_t> whole = bytesOf(kAdapter);
    // Offsets of the lengths of IFLA_IFNAME, IFLA_LINKINFO, IFLA_INFO_KIND, IFLA_INFO_DATA, IFLA_CAN_BITTIMING.
    for (const std::size_t offset : {32U, 52U, 56U, 64U, 68U}) {
        for (const std::uint8_t length : {std::uint8_t{0}, std::uint8_t{3}, std::uint8_t{255}}) {
            std::vector<std::uint8_t> lying = whole;
            lying[offset] = length;
            EXPECT_FALSE(readInterfaceAnswer(lying).has_value()) << offset << ' ' << int{length};
        }
    }
}

TEST_F(InterfaceReportTest, OtherMessagesAreRefused)
{
    EXPECT_FALSE(readInterfaceAnswer({}).has_value());
    // NLMSG_ERROR with -ENODEV, and the query that it answers.
    EXPECT_FALSE(readInterfaceAnswer(bytesOf("24000000 0200 0000 01000000 00000000 edffffff"
                                             "20000000 1200 0100 01000000 00000000"))
                     .has_value());
}

// REQ-CAN-15 (BitTimingTest.*)
TEST(BitTimingTest, WhatAdaptersCanMakeOfTheWantedTimingIsRight)
{
    EXPECT_EQ(timingTrouble(adapter()), QString());
    for (const double samplePoint : {0.625, 0.647, 0.666, 0.671, 0.706, 0.0}) {
        InterfaceReport report = adapter();
        report.nominal->samplePoint = samplePoint;
        report.data->samplePoint = samplePoint;
        EXPECT_EQ(timingTrouble(report), QString()) << samplePoint;
    }
}

// The result of "ip link set can0 up type can bitrate 500000 dbitrate 2000000 fd on", with the kernel's own sample
// points.
TEST(BitTimingTest, EveryWrongValueIsNamedBesideTheWantedOneAndTheCommands)
{
    InterfaceReport report = adapter();
    report.nominal = PhaseTiming{.bitRate = 500'000, .samplePoint = 0.875};
    report.data = PhaseTiming{.bitRate = 2'000'000, .samplePoint = 0.75};
    EXPECT_EQ(
        timingTrouble(report).toStdString(),
        "wrong bit timing, so the drives may stay silent: bit rate 500000 (wanted 1000000), sample point 0.875 "
        "(wanted 0.666), data bit rate 2000000 (wanted 5000000), data sample point 0.750 (wanted 0.666). Enter "
        "`ip link set can0 down`, then `ip link set can0 up type can bitrate 1000000 dbitrate 5000000 sjw 10 dsjw 5 "
        "sample-point 0.666 dsample-point 0.666 restart-ms 1000 fd on`. `ip -details link show can0` shows the "
        "values in use");
}

TEST(BitTimingTest, SamplePointLeftToTheKernelIsSaid)
{
    InterfaceReport report = adapter();
    report.nominal->samplePoint = 0.75;
    EXPECT_THAT(timingTrouble(report).toStdString(), HasSubstr(": sample point 0.750 (wanted 0.666). Enter `ip"));
    report = adapter();
    report.data->samplePoint = 0.75;
    EXPECT_THAT(timingTrouble(report).toStdString(), HasSubstr(": data sample point 0.750 (wanted 0.666). Enter `ip"));
}

TEST(BitTimingTest, ClassicModeIsSaidOnce)
{
    InterfaceReport report = adapter();
    report.flexibleData = false;
    report.data = PhaseTiming{};
    EXPECT_THAT(timingTrouble(report).toStdString(), HasSubstr(": CAN-FD off (wanted on). Enter `ip"));
}

// REQ-CAN-16: For a silent bus that is up there is one advice for every kind of bus.
TEST(BusAdviceTest, SilenceNamesTimingWiringPowerAndIds)
{
    const std::string onCan = silenceAdvice({BusKind::SocketCan, "can0"}).toStdString();
    for (const char* part : {"powered", "cable", "120 ohm", "1M/5M", "0.666", "`ip -details link show can0`",
                             "`packaging/can-up can0`", "ids", "`boresightctl scan socketcan:can0`"}) {
        EXPECT_THAT(onCan, HasSubstr(part));
    }
    const std::string onUsb = silenceAdvice({BusKind::Fdcanusb, "/dev/ttyACM0"}).toStdString();
    for (const char* part : {"powered", "120 ohm", "1M/5M", "0.666", "can.fd_bitrate", "ids", "Release the bus"}) {
        EXPECT_THAT(onUsb, HasSubstr(part));
    }
    EXPECT_THAT(onUsb, Not(HasSubstr("ip -details")));
    const std::string onVirtual = silenceAdvice({BusKind::SocketCan, "vcan0"}).toStdString();
    EXPECT_THAT(onVirtual, HasSubstr("boresightctl simulate --can vcan0"));
    EXPECT_THAT(onVirtual, Not(HasSubstr("0.666")));
    EXPECT_THAT(silenceAdvice({}).toStdString(), HasSubstr("simulated"));
}

}  // namespace
}  // namespace boresight::socketcan
