// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus/codec.h"

#include "tests/core/moteus/golden.h"
#include "tests/fakes/text_of.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace boresight::moteus {
namespace {

using golden::toHex;

// The request of the station in each cycle: everything that a drive needs to be safe, and a query of the full report.
Request trackingRequest()
{
    PositionCommand command;
    command.position = -0.375;
    command.velocity = 0.01;
    command.maximumTorque = 2.0;
    command.watchdogTimeout = 0.2;
    command.velocityLimit = 0.05;
    command.accelerationLimit = 0.1;
    return {.destination = 2, .command = command, .query = rotatorQuery()};
}

// REQ-MOTEUS-07: The tracking command with watchdog, limits and the full report fits one frame.
TEST(MoteusCodec, TrackingCommandAndFullReportFitOneFrame)
{
    const auto frame = encode(trackingRequest());
    ASSERT_TRUE(frame) << textOf(frame.error());
    EXPECT_EQ(frame->size, 48);
    EXPECT_EQ(toHex(frame->payload()),
              "01000a"                            // mode = position
              "0e200000c0be0ad7233c"              // position, velocity
              "0d2500000040"                      // maximum torque
              "0f27cdcc4c3ecdcc4c3dcdcccc3d"      // watchdog, velocity and acceleration limit
              "11001f01160415071e38114014060a");  // the report
}

// In the same frame and before the command takes effect: the drive collects the command until the end of the frame.
TEST(MoteusCodec, APositionCommandCanRestartTheControlWhereTheAxisIs)
{
    const auto writes = registerWrites(PositionCommand{.position = kKeepControlPosition, .recapture = true});
    ASSERT_EQ(writes.size(), 3U);
    EXPECT_EQ(writes[0].reg, Register::Mode);
    EXPECT_EQ(writes[2].reg, Register::RecapturePositionVelocity);
}

TEST(MoteusCodec, APositionCommandCanSayWhatItsReplyRepeats)
{
    const auto writes = registerWrites(PositionCommand{.echo = Field{0.05, Resolution::Int8}});
    ASSERT_EQ(writes.size(), 2U);
    EXPECT_EQ(writes[0].reg, Register::Mode) << "writing it resets the fields of every command";
    EXPECT_EQ(writes[1].reg, Register::StayWithinLower);
}

TEST(MoteusCodec, BlankFieldsAreNotSent)
{
    const auto writes = registerWrites(PositionCommand{});
    ASSERT_EQ(writes.size(), 1U);
    EXPECT_EQ(writes[0].reg, Register::Mode);
    EXPECT_EQ(writes[0].value, 10);
}

TEST(MoteusCodec, NamedSpecialValuesTravelAsTheProtocolWants)
{
    PositionCommand command;
    command.position = kKeepControlPosition;
    command.velocity = 0.0;
    command.watchdogTimeout = {kNoWatchdog, Resolution::Int16};
    command.velocityLimit = {kConfiguredLimit, Resolution::Int16};
    command.accelerationLimit = {kNoLimit, Resolution::Int16};
    const auto frame = encode({.command = command, .query = {}});
    ASSERT_TRUE(frame);
    EXPECT_EQ(toHex(frame->payload()),
              "01000a0e200000c07f00000000"  // NaN, 0.0
              "0727008000801"
              "8fc"  // NaN, NaN, -1 rev/s² = -1000 steps
              "505050");
}

TEST(MoteusCodec, BenchModesWriteTheirRegisters)
{
    const auto payload = [](const Command& command) {
        SubframeWriter writer;
        writer.appendWrites(registerWrites(command));
        return toHex(writer.bytes());
    };
    const Field half{0.5, Resolution::Float};
    const Field volts{12.0, Resolution::Int8};
    EXPECT_EQ(payload(PwmCommand{.a = half, .b = {}, .c = half}), "0100050d100000003f0d120000003f");
    EXPECT_EQ(payload(VoltageCommand{.a = volts, .b = volts, .c = volts}), "0100060314181818");
    EXPECT_EQ(payload(VoltageDqCommand{.d = {}, .q = volts}), "010008011b18");
}

// REQ-MOTEUS-08: UUID masks come first, a broadcast reaches every drive, and a mismatch discards the frame.
TEST(MoteusCodec, UuidMaskComesBeforeTheCommand)
{
    const auto frame = encode({.destination = kBroadcastId,
                               .uuid = UuidMask{.uuid = {0x7141e628, 0x10b3c957, 1, 2}, .words = 2},
                               .command = Stop{},
                               .query = {{Register::Mode, Resolution::Int8}}});
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->id, 0x807fU);
    EXPECT_EQ(toHex(frame->payload()),
              "0ad40228e6417157c9b310"
              "010000"
              "1100");
}

TEST(MoteusCodec, HighUuidWordsKeepTheirBits)
{
    const auto frame = encode({.uuid = UuidMask{.uuid = {0xfedcba98, 0, 0, 0}, .words = 1}, .query = {}});
    ASSERT_TRUE(frame);
    EXPECT_EQ(toHex(frame->payload()), "09d40298badcfe");
}

// REQ-MOTEUS-06: These are refused with a reason: a request over 64 bytes, a query that cannot be answered, a register
// that cannot be read, and an impossible id. A reply over 64 bytes cannot be sent. The drive drops a block that would
// begin after byte 41 without an error. Everything else is answered completely.
TEST(MoteusCodec, RefusesWhatDoesNotFitTheRequest)
{
    Request request = trackingRequest();
    auto& command = std::get<PositionCommand>(*request.command);
    command.feedforwardTorque = 0.1;
    command.kpScale = 1.0;
    command.kdScale = 1.0;
    command.integralLimitScale = 1.0;
    command.fixedVoltage = 1.0;
    const auto frame = encode(request);
    ASSERT_FALSE(frame);
    EXPECT_EQ(frame.error().code, ErrorCode::OutOfRange);
    EXPECT_NE(textOf(frame.error()).find("of 64 bytes"), std::string::npos) << textOf(frame.error());
}

// REQ-MOTEUS-06
TEST(MoteusCodec, RefusesAQueryWhoseTailWouldBeMissing)
{
    Query query = rotatorQuery();  // 55 bytes: one more block would begin too late
    EXPECT_TRUE(checkAnswerable(query));
    query.push_back({Register::PositionError, Resolution::Float});
    const auto frame = encode({.query = query});
    ASSERT_FALSE(frame);
    EXPECT_EQ(textOf(frame.error()), "the last part of the reply would start after byte 41 and be left out");
}

// REQ-MOTEUS-06
TEST(MoteusCodec, RefusesImpossibleQueries)
{
    const auto refused = [](const Request& request) { return !encode(request).has_value(); };
    EXPECT_TRUE(refused({.query = {{Register::SetOutputExact, Resolution::Float}}}));
    EXPECT_TRUE(refused({.query = {{static_cast<Register>(0x09), Resolution::Float}}}));
    EXPECT_TRUE(refused({.query = {{Register::ModelNumber, Resolution::Float}}}));
    EXPECT_TRUE(refused({.query = basicQuery(), .replyWanted = false}));
    EXPECT_TRUE(refused({.destination = 0, .query = {}}));
    EXPECT_TRUE(refused({.destination = 128, .query = {}}));
    EXPECT_TRUE(refused({.prefix = 0x2000, .query = {}}));
    EXPECT_TRUE(refused({.uuid = UuidMask{.words = 5}, .query = {}}));
}

TEST(MoteusCodec, ReplySizesOfTheStandardQueries)
{
    EXPECT_EQ(replySize(basicQuery()), 22U);
    EXPECT_EQ(replySize(rotatorQuery()), 55U);
    EXPECT_EQ(replySize(discoveryQuery()), 24U);
    EXPECT_EQ(replySize(versionQuery()), 15U);
}

TEST(MoteusCodec, ReplyGivesValuesByRegister)
{
    // mode 10, position 0.25 f32, velocity unset i16, home state 2, fault 99 (a limit), UUID
    const auto reply =
        decodeReply(golden::frame(0x200, golden::bytes(QStringLiteral("21000a2d010000803e25020080210c02210f63") +
                                                       QStringLiteral("2804d00298badcfe020000000300000004000000"))));
    ASSERT_TRUE(reply);
    EXPECT_EQ(reply->source, 2);
    EXPECT_EQ(reply->destination, 0);
    EXPECT_EQ(reply->mode(), Mode::Position);
    EXPECT_EQ(reply->value(Register::Position), 0.25);
    EXPECT_EQ(reply->value(Register::Velocity), std::nullopt);
    EXPECT_EQ(reply->value(Register::Torque), std::nullopt);
    EXPECT_EQ(reply->homeState(), HomeState::Output);
    EXPECT_EQ(reply->fault(), 99);
    EXPECT_EQ(reply->uuid(), (Uuid{0xfedcba98, 2, 3, 4}));
}

TEST(MoteusCodec, NonsenseInAReplyIsNoValue)
{
    // mode 200 as i16, fault 1e30 and home state -1 as f32 and i8
    const auto reply = decodeReply(golden::frame(0x100, golden::bytes(QStringLiteral("2500c8002d0fcaf249712"
                                                                                     "10cff"))));
    ASSERT_TRUE(reply);
    EXPECT_EQ(reply->values.size(), 3U);
    EXPECT_EQ(reply->mode(), std::nullopt);
    EXPECT_EQ(reply->fault(), std::nullopt);
    EXPECT_EQ(reply->homeState(), std::nullopt);
    EXPECT_EQ(reply->uuid(), std::nullopt);
}

// Found by the fuzzer: an infinite position reached the station as a measured value.
TEST(MoteusCodec, AnInfiniteNumberIsNoValue)
{
    CanFrame frame{.id = 0x100};
    frame.setPayload(std::array<std::uint8_t, 6>{0x2d, 0x01, 0x00, 0x00, 0x80, 0x7f});  // position f32 = +inf
    const auto reply = decodeReply(frame);
    ASSERT_TRUE(reply.has_value());
    ASSERT_EQ(reply->values.size(), 1U);
    EXPECT_FALSE(reply->value(Register::Position).has_value());
}

TEST(MoteusCodec, ErrorsAreReported)
{
    const auto reply = decodeReply(golden::frame(0x100, {0x30, 0x01, 0x02, 0x31, 0x09, 0x01}));
    ASSERT_TRUE(reply);
    EXPECT_EQ(reply->errors, (std::vector<RegisterError>{{Register::Position, kNotWritable, true},
                                                         {static_cast<Register>(9), kUnknownRegister, false}}));
}

TEST(MoteusCodec, ARequestIsNoReply)
{
    const auto reply = decodeReply(golden::frame(0x8001, {0x11, 0x00}));
    ASSERT_FALSE(reply);
    EXPECT_EQ(reply.error().code, ErrorCode::Protocol);
}

}  // namespace
}  // namespace boresight::moteus
