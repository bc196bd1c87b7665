// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim_bus/fdcanusb_server.h"

#include "core/base/hex.h"
#include "core/can/fdcanusb_protocol.h"
#include "core/can/line_checksum.h"
#include "core/sim_bus/fdcanusb_request.h"
#include "tests/core/sim/golden_vectors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace boresight::sim {
namespace {

std::string stdText(const QJsonObject& object, const char* key)
{
    return object.value(QLatin1String(key)).toString().toStdString();
}

// REQ-SIM-11 (FdcanusbServerGolden.*): The simulated adapter reads and writes lines as recorded. Each line is answered
// in its own style. This includes half lines and ERR texts.
TEST(FdcanusbServerGolden, ReadsTheClientsLines)
{
    for (const QJsonValue& value : golden::vectors("serial_lines")) {
        const QJsonObject vector = value.toObject();
        SCOPED_TRACE(stdText(vector, "name"));
        const std::string sent = stdText(vector, "tx_line");
        const fdcanusb::CheckedLine checked = fdcanusb::splitChecksum(sent);
        EXPECT_EQ(checked.checksum == fdcanusb::Checksum::Right, vector[QLatin1String("checksum")].toBool());
        const auto frame = parseSendRequest(checked.text);
        ASSERT_TRUE(frame) << frame.error();
        EXPECT_EQ(frame->id, static_cast<std::uint32_t>(std::stoul(stdText(vector, "arbitration_id"), nullptr, 16)));
        EXPECT_TRUE(toHex(frame->payload()).starts_with(stdText(vector, "data")));
        const QJsonValue bitRateSwitch = vector[QLatin1String("brs")];
        EXPECT_EQ(frame->bitRateSwitch, bitRateSwitch.isNull() || bitRateSwitch.toBool());
    }
}

// Lines with flags come from an adapter. A moteus UART leaves the flags out, and the simulator never does.
TEST(FdcanusbServerGolden, WritesReceivedFramesLikeTheAdapter)
{
    int compared = 0;
    for (const QJsonValue& value : golden::vectors("serial_lines")) {
        const QJsonObject vector = value.toObject();
        if (!vector.contains(QLatin1String("rx_line")) || vector[QLatin1String("checksum")].toBool()) {
            continue;
        }
        const std::string line = stdText(vector, "rx_line");
        const fdcanusb::Answer answer = fdcanusb::parseAnswer(line);
        const auto* frame = std::get_if<CanFrame>(&answer);
        ASSERT_NE(frame, nullptr) << line;
        EXPECT_EQ(receivedLine(*frame), line);
        ++compared;
    }
    EXPECT_GE(compared, 6);
}

TEST(FdcanusbRequest, SaysWhatIsWrongInTheAdaptersWords)
{
    const auto why = [](std::string_view line) { return parseSendRequest(line).error(); };
    EXPECT_EQ(why("can send 8001"), "insufficient options");
    EXPECT_EQ(why("can send 80g1 11"), "bad id");
    EXPECT_EQ(why("can std 8001 11"), "bad id");
    EXPECT_EQ(why("can send 8001  11"), "data invalid length") << "two spaces: an empty field";
    EXPECT_EQ(why("can send 8001 110"), "data invalid length");
    EXPECT_EQ(why("can send 8001 " + std::string(130, '0')), "data invalid length");
    EXPECT_EQ(why("can send 8001 11zz"), "invalid data");
    EXPECT_EQ(why("can send 8001 1100 Q"), "unknown flag");
    EXPECT_EQ(why("can send 8001 112233445566778899 f"), "data invalid length") << "nine bytes of classic CAN";
}

TEST(FdcanusbRequest, PadsWithZerosLikeTheAdapter)
{
    const auto frame = parseSendRequest("can ext 101 112233445566778899 BF");
    ASSERT_TRUE(frame);
    EXPECT_TRUE(frame->extended);
    EXPECT_EQ(toHex(frame->payload()), "112233445566778899000000");
}

class FdcanusbServerTest : public testing::Test
{
protected:
    std::string say(const std::string& line) { return server.receive(line + "\n", now); }
    FaultSchedule::Handle inject(FaultKind kind, std::optional<double> value = std::nullopt)
    {
        return pair.faults().add({.kind = kind, .value = value});
    }

    SimulatedPair pair{commissionedPair()};
    FdcanusbServer server{pair};
    Seconds now{1.0};
};

constexpr const char* kAskMode = "can send 8001 1100 BF";  // mode as i8
constexpr const char* kModeStopped = "OK\r\nrcv 0100 210000 e B F r x-1\r\n";

// REQ-SIM-10 (FdcanusbServerTest.*)
// REQ-SIM-11 (FdcanusbServerTest.*)
TEST_F(FdcanusbServerTest, AnswersOkThenTheReply)
{
    EXPECT_EQ(say(kAskMode), kModeStopped);
    EXPECT_EQ(say("can send 8001 1100 B F"), kModeStopped) << "flags in two words";
    EXPECT_EQ(say("can send 8001 50 BF"), "OK\r\nrcv 0100  e B F r x-1\r\n") << "an empty reply keeps its flags";
    EXPECT_EQ(say("can send 1 1100 BF"), "OK\r\n") << "no reply asked";
    EXPECT_EQ(say("can send 8005 1100 BF"), "OK\r\n") << "nobody has id 5";
}

TEST_F(FdcanusbServerTest, EachLineIsAnsweredInItsOwnStyle)
{
    const std::string checked = say(fdcanusb::withChecksum(kAskMode));
    EXPECT_TRUE(checked.starts_with("OK *BD\r\n"));
    const std::size_t second = checked.find("rcv");
    const std::string reply = checked.substr(second, checked.size() - second - 2);
    EXPECT_EQ(fdcanusb::splitChecksum(reply).checksum, fdcanusb::Checksum::Right) << reply;
    EXPECT_EQ(say(kAskMode), kModeStopped) << "a later client without checksums is not locked out";
    EXPECT_TRUE(say(std::string(kAskMode) + " *00").starts_with("ERR checksum *"));
}

TEST_F(FdcanusbServerTest, HalfLinesAndSeveralLinesAtOnce)
{
    EXPECT_EQ(server.receive("can send 80", now), "");
    EXPECT_EQ(server.receive("01 1100 BF", now), "");
    EXPECT_EQ(server.receive("\r\ncan send 8002 1100 BF\r\n", now),
              std::string(kModeStopped) + "OK\r\nrcv 0200 210000 e B F r x-1\r\n");
    EXPECT_EQ(server.receive("can send 8001", now), "");
    server.clientGone();
    EXPECT_EQ(say(kAskMode), kModeStopped) << "the next client does not inherit a half line";
}

TEST_F(FdcanusbServerTest, RefusesWhatItDoesNotKnow)
{
    EXPECT_EQ(say("hello"), "ERR unknown command\r\n");
    EXPECT_EQ(say("can fly"), "ERR unknown subcommand\r\n");
    EXPECT_EQ(say("can send 8001"), "ERR insufficient options\r\n");
    EXPECT_EQ(say("can send 8001 1"), "ERR data invalid length\r\n");
}

TEST_F(FdcanusbServerTest, HasSettingsLikeTheAdapter)
{
    EXPECT_EQ(say("conf get can.bitrate"), "1000000\r\n");
    EXPECT_EQ(say("conf set can.termination 0"), "OK\r\n");
    EXPECT_EQ(say("conf get can.termination"), "0\r\n");
    EXPECT_EQ(say("conf get can.nothing"), "ERR error reading\r\n");
}

TEST_F(FdcanusbServerTest, BroadcastBringsBothReplies)
{
    const std::string answer = say("can send 807f 1804d00211d802 BF");
    EXPECT_NE(answer.find("rcv 0100 2804D002626F7265"), std::string::npos) << answer;
    EXPECT_NE(answer.find("rcv 0200 2804D002626F7265"), std::string::npos) << answer;
}

TEST_F(FdcanusbServerTest, CorruptLinesAreNoFrames)
{
    inject(FaultKind::CorruptLine, 1.0);
    for (const bool checksum : {false, true}) {
        const std::string answer = say(checksum ? fdcanusb::withChecksum(kAskMode) : kAskMode);
        const std::string line = answer.substr(answer.find('\n') + 1);
        EXPECT_TRUE(
            std::holds_alternative<fdcanusb::Unreadable>(fdcanusb::parseAnswer(line.substr(0, line.find('\r')))))
            << line;
    }
}

TEST_F(FdcanusbServerTest, MissingOkLeavesTheReply)
{
    inject(FaultKind::MissingOk);
    EXPECT_EQ(say(kAskMode), "rcv 0100 210000 e B F r x-1\r\n");
}

TEST_F(FdcanusbServerTest, AdapterErrorSendsNothing)
{
    inject(FaultKind::AdapterError);
    EXPECT_EQ(say("can send 0001 01000f BF"), "ERR invalid data\r\n");
    pair.advanceTo(Seconds(2.0));
    EXPECT_EQ(pair.truth(Axis::Azimuth).mode, moteus::Mode::Stopped) << "the brake command never reached the drive";
}

TEST_F(FdcanusbServerTest, BusOffStaysUntilSwitchedOffAndOn)
{
    const auto handle = inject(FaultKind::BusOff);
    EXPECT_EQ(say(kAskMode), "ERR not in BusOn state\r\n");
    EXPECT_NE(say("can status").find("busoff=1"), std::string::npos);
    pair.faults().remove(handle);
    EXPECT_EQ(say(kAskMode), "ERR not in BusOn state\r\n") << "no automatic recovery";
    EXPECT_NE(say("can status").find("busoff=0"), std::string::npos);
    EXPECT_EQ(say("can off"), "OK\r\n");
    EXPECT_EQ(say("can on"), "OK\r\n");
    EXPECT_EQ(say(kAskMode), kModeStopped);
}

TEST_F(FdcanusbServerTest, LateRepliesComeWhenDue)
{
    inject(FaultKind::LateReply, 0.25);
    EXPECT_EQ(say(kAskMode), "OK\r\n");
    EXPECT_EQ(server.nextDue(), now + Seconds(0.25));
    EXPECT_EQ(server.takeDue(now + Seconds(0.24)), "");
    EXPECT_EQ(server.takeDue(now + Seconds(0.25)), "rcv 0100 210000 e B F r x-1\r\n");
}

}  // namespace
}  // namespace boresight::sim
