// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus/frame_server.h"

#include "core/moteus/codec.h"
#include "tests/core/moteus/golden.h"
#include "tests/core/moteus/recording_device.h"

#include <gtest/gtest.h>

#include <random>

namespace boresight::moteus {
namespace {

using golden::toHex;

class MoteusFrameServer : public testing::Test
{
protected:
    std::optional<CanFrame> ask(const char* request, std::uint32_t id = 0x8001)
    {
        return server.serve(golden::frame(id, golden::bytes(QString::fromLatin1(request))), {}, device);
    }
    std::string answer(const char* request)
    {
        const auto reply = ask(request);
        return reply ? toHex(reply->payload()) : "none";
    }

    RecordingDevice device;
    FrameServer server;
};

TEST_F(MoteusFrameServer, RepliesInTheMannerOfTheRequest)
{
    CanFrame request = golden::frame(0x8001, {0x11, 0x00});
    request.bitRateSwitch = false;
    EXPECT_FALSE(server.serve(request, {}, device)->bitRateSwitch);
    request.flexibleData = false;
    EXPECT_FALSE(server.serve(request, {}, device)->flexibleData);
    request.setPayload(std::vector<std::uint8_t>{0x1f, 0x01});  // the reply has 14 bytes, too many for classic CAN
    EXPECT_TRUE(server.serve(request, {}, device)->flexibleData);
}

TEST_F(MoteusFrameServer, AnswersUnderItsPrefixAndToTheSource)
{
    const auto reply = server.serve(golden::frame(0x1974c809, {0x50}), {.id = 9, .prefix = 0x1974}, device);
    ASSERT_TRUE(reply);
    EXPECT_EQ(reply->id, 0x19740948U);
    EXPECT_TRUE(reply->extended);
}

TEST_F(MoteusFrameServer, ABlockThatDoesNotFitIsAnErrorAndTheNextIsServed)
{
    // 7 x f32 (31 bytes), 10 x f32 (43 bytes, no room), then the mode
    EXPECT_EQ(answer("1c07001c0a201100").substr(62), "3120022100005050505050505050505050");
}

TEST_F(MoteusFrameServer, AHostileCountIsNoRoom)
{
    EXPECT_EQ(answer("1cffffffff0f00"), "310002");
}

TEST_F(MoteusFrameServer, WriteErrorsDoNotStopTheFrame)
{
    EXPECT_EQ(answer("010e05"
                     "010e06"
                     "1100"),
              "300e02300e02210000505050");
    EXPECT_TRUE(device.writes.empty());
}

TEST_F(MoteusFrameServer, ManyWriteErrorsNeverOverfillTheReply)
{
    const auto reply =
        ask("003d0e00000000000000000000000000000000000000000000000000000000000000000000000000000000000000"
            "00000000000000000000000000000000");
    ASSERT_TRUE(reply);
    EXPECT_LE(reply->size, 64);
}

// REQ-MOTEUS-08
TEST_F(MoteusFrameServer, TellsTheDeviceWhetherTheFrameCounts)
{
    device.registers[Register::Uuid] = 0x11223344;
    static_cast<void>(ask("09d40244332211010000"));
    EXPECT_EQ(device.ends, std::vector{ServedDevice::FrameEnd::Accepted});
    EXPECT_EQ(device.writes.size(), 1U);
    EXPECT_FALSE(ask("09d40245332211010000"));
    EXPECT_EQ(device.ends.back(), ServedDevice::FrameEnd::Discarded);
    EXPECT_EQ(device.writes.size(), 1U);
    EXPECT_EQ(answer("01d402441100"), "30d40201210000");  // the mask exists as i32 only
}

TEST_F(MoteusFrameServer, FramesForOthersAreNotEvenLookedAt)
{
    EXPECT_FALSE(ask("010000", 0x8002));
    EXPECT_TRUE(device.ends.empty());
}

TEST_F(MoteusFrameServer, TunnelTakesTextWithoutAReplyBit)
{
    EXPECT_FALSE(ask("4001046f6b0d0a", 0x0001));
    EXPECT_EQ(device.received, "ok\r\n");
}

TEST_F(MoteusFrameServer, ALostPacketIsRepeatedAndAnEmptyOneCounts)
{
    device.text = "one";
    EXPECT_EQ(answer("44010030"), "430101036f6e65");
    EXPECT_EQ(answer("44010030"), "430101036f6e65");
    EXPECT_EQ(answer("44010130"), "43010200");
    EXPECT_EQ(answer("44010130"), "43010300");
    EXPECT_TRUE(device.text.empty());
}

TEST_F(MoteusFrameServer, TextStaysWithinTheRoomOfItsReply)
{
    device.text = std::string(100, 'x');
    EXPECT_EQ(decodeReply(*ask("42013d"))->texts[0].text.size(), 39U);
    EXPECT_EQ(decodeReply(*ask("4401003d"))->texts[0].text.size(), 38U);
    // After 33 bytes of registers only a little room is left, but the poll is answered.
    EXPECT_EQ(decodeReply(*ask("1c080042013d"))->texts[0].text.size(), 4U);
}

// 8 x f32 (35 bytes) and one i32 (6): the next block starts at byte 41, the last permitted place.
// REQ-MOTEUS-06
TEST_F(MoteusFrameServer, TheLastBlockMayStartAtByte41ButNotLater)
{
    Query query;
    for (std::uint32_t number = 0; number < 8; ++number) {
        query.push_back({static_cast<Register>(number), Resolution::Float});
    }
    query.push_back({Register::MotorTemperature, Resolution::Int32});
    EXPECT_EQ(replySize(query), 41U);
    query.push_back({Register::Voltage, Resolution::Int8});
    const auto request = encode({.query = query});
    ASSERT_TRUE(request);
    EXPECT_EQ(decodeReply(*server.serve(*request, {}, device))->values.size(), query.size());

    query.push_back({Register::Fault, Resolution::Int8});
    EXPECT_FALSE(encode({.query = query}));
    SubframeWriter unchecked;
    unchecked.appendReads(query);
    const auto reply = server.serve(makeFrame({.replyWanted = true}, unchecked.bytes()), {}, device);
    EXPECT_EQ(decodeReply(*reply)->values.size(), query.size() - 1);
}

// A query that the client considers answerable is answered completely, with the predicted size.
// REQ-MOTEUS-06
TEST_F(MoteusFrameServer, EveryAnswerableQueryIsAnsweredInFull)
{
    std::mt19937 random(4);
    int answered = 0;
    for (int round = 0; round < 3'000; ++round) {
        Query query;
        for (std::uint32_t number = 0; number < 0x60; ++number) {
            const RegisterRead read{static_cast<Register>(number), static_cast<Resolution>(random() % 4)};
            if (isReadable(read.reg) && random() % 6 == 0) {
                query.push_back(read);
            }
        }
        const auto request = encode({.query = query});
        if (!request) {
            continue;
        }
        const auto reply = server.serve(*request, {}, device);
        ASSERT_TRUE(reply);
        EXPECT_EQ(reply->size, legalCanLength(replySize(query)));
        const auto values = decodeReply(*reply)->values;
        ASSERT_EQ(values.size(), query.size());
        ++answered;
    }
    EXPECT_GT(answered, 500);
}

}  // namespace
}  // namespace boresight::moteus
