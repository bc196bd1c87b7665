// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus/subframes.h"

#include "core/moteus/arbitration.h"
#include "tests/core/moteus/golden.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace boresight::moteus {
namespace {

using golden::toHex;

std::vector<Subframe> readAll(std::span<const std::uint8_t> payload, ParseEnd expectedEnd)
{
    std::vector<Subframe> result;
    SubframeReader reader(payload);
    while (auto subframe = reader.next()) {
        result.push_back(*subframe);
    }
    EXPECT_EQ(reader.end(), expectedEnd);
    return result;
}

TEST(MoteusSubframes, GroupsGreedilyByNumberAndResolution)
{
    SubframeWriter writer;
    writer.appendReads(std::vector<RegisterRead>{{Register::Mode, Resolution::Int8},
                                                 {Register::Position, Resolution::Float},
                                                 {Register::Velocity, Resolution::Float},
                                                 {Register::Torque, Resolution::Float},
                                                 {Register::Voltage, Resolution::Int8},
                                                 {Register::Temperature, Resolution::Int8},
                                                 {Register::Fault, Resolution::Int8}});
    // 11 00: mode as i8 | 1f 01: three f32 from 001 | 13 0d: three i8 from 00d
    EXPECT_EQ(toHex(writer.bytes()), "11001f01130d");
}

TEST(MoteusSubframes, MoreThanThreeRegistersWriteTheirCount)
{
    std::vector<RegisterRead> reads;
    for (std::uint32_t i = 0; i < 4; ++i) {
        reads.push_back({Register::Uuid + i, Resolution::Int32});
    }
    SubframeWriter writer;
    writer.appendReads(reads);
    EXPECT_EQ(toHex(writer.bytes()), "1804d002");  // 0x150 = d0 02 as a varuint
}

TEST(MoteusSubframes, CutValuesAreGivenUpToTheLastCompleteOne)
{
    const std::vector<std::uint8_t> payload{0x24, 0x04, 0x00, 0x0a, 0x00, 0x66, 0x03, 0xbe};
    const auto parts = readAll(payload, ParseEnd::Truncated);
    ASSERT_EQ(parts.size(), 1U);
    const auto& block = std::get<ReplyBlock>(parts[0]);
    EXPECT_EQ(block.count, 2U);
    EXPECT_EQ(block.value(0).value, 10);
    EXPECT_NEAR(block.value(1).value, 0.087, 1e-12);
}

TEST(MoteusSubframes, UnknownTypesEndTheWalk)
{
    const std::vector<std::uint8_t> payload{0x50, 0x60, 0x11, 0x00};
    EXPECT_EQ(readAll(payload, ParseEnd::Unknown).size(), 1U);
}

TEST(MoteusSubframes, NumbersBeyond32BitsAreRefused)
{
    const std::vector<std::uint8_t> tooLarge{0x31, 0xff, 0xff, 0xff, 0xff, 0x1f, 0x01};
    const std::vector<std::uint8_t> tooLong{0x31, 0x80, 0x80, 0x80, 0x80, 0x80, 0x00, 0x01};
    const std::vector<std::uint8_t> largest{0x31, 0xff, 0xff, 0xff, 0xff, 0x0f, 0x01};
    EXPECT_TRUE(readAll(tooLarge, ParseEnd::Truncated).empty());
    EXPECT_TRUE(readAll(tooLong, ParseEnd::Truncated).empty());
    const auto parts = readAll(largest, ParseEnd::Complete);
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_EQ(std::get<ReadError>(parts[0]).reg, static_cast<Register>(0xffffffff));
}

TEST(MoteusSubframes, TextLongerThanItsFrameIsNotDelivered)
{
    const std::vector<std::uint8_t> payload{0x41, 0x01, 0x05, 'O', 'K'};
    EXPECT_TRUE(readAll(payload, ParseEnd::Truncated).empty());
}

TEST(MoteusSubframes, WriterCountsPastTheEndButNeverWritesThere)
{
    SubframeWriter writer;
    std::vector<RegisterValue> writes;
    for (std::uint32_t i = 0; i < 14; ++i) {
        writes.push_back({Register::CommandPosition + i, Resolution::Float, 1.0});
        writes.push_back({Register::Mode, Resolution::Int8, 0.0});
    }
    writer.appendWrites(writes);
    EXPECT_TRUE(writer.overflowed());
    EXPECT_EQ(writer.needed(), 14U * 6 + 14U * 3);
    EXPECT_EQ(writer.bytes().size(), 64U);
    EXPECT_EQ(writer.room(), 0U);
}

TEST(MoteusSubframes, RandomValuesReadBackAsWritten)
{
    std::mt19937 random(2);
    for (int round = 0; round < 2'000; ++round) {
        std::vector<RegisterValue> values;
        auto reg = static_cast<Register>(random() % 0x20);
        for (unsigned i = 0; i < 1 + random() % 8; ++i) {
            const double value = std::ldexp(static_cast<double>(random()) - 2147483648.0, -31);
            values.push_back({reg, static_cast<Resolution>(random() % 4), random() % 10 == 0 ? std::nan("") : value});
            reg = reg + 1 + random() % 2;
        }
        SubframeWriter writer;
        writer.appendReplies(values, Side::Client);
        std::size_t next = 0;
        for (const Subframe& part : readAll(writer.bytes(), ParseEnd::Complete)) {
            const auto& block = std::get<ReplyBlock>(part);
            for (std::uint32_t i = 0; i < block.count; ++i, ++next) {
                const RegisterValue& sent = values[next];
                const Kind kind = registerKind(sent.reg).value_or(Kind::Integer);
                EXPECT_EQ(block.value(i).reg, sent.reg);
                EXPECT_EQ(toWire(sent.value, kind, sent.resolution) << (32 - 8 * sizeInBytes(sent.resolution)),
                          block.bits(i) << (32 - 8 * sizeInBytes(sent.resolution)));
            }
        }
        EXPECT_EQ(next, values.size());
    }
}

TEST(MoteusArbitration, EveryIdentifierComesBack)
{
    std::mt19937 random(3);
    for (int i = 0; i < 2'000; ++i) {
        const Arbitration sent{.prefix = static_cast<std::uint16_t>(random() & kMaxPrefix),
                               .replyWanted = random() % 2 == 0,
                               .source = static_cast<std::uint8_t>(random() & 0x7f),
                               .destination = static_cast<std::uint8_t>(random() & 0x7f)};
        EXPECT_EQ(fromCanId(toCanId(sent)), sent);
    }
}

TEST(MoteusArbitration, IdentifiersAbove0x7ffAreExtended)
{
    const auto extended = [](const Arbitration& id) { return makeFrame(id, {}).extended; };
    EXPECT_FALSE(extended({.source = 0, .destination = 1}));
    EXPECT_TRUE(extended({.replyWanted = true, .source = 0, .destination = 1}));
    EXPECT_FALSE(extended({.source = 7, .destination = 0x7f}));  // a reply of drive 7
    EXPECT_TRUE(extended({.source = 8, .destination = 0}));      // a reply of drive 8
}

TEST(MoteusArbitration, ADriveTakesItsIdAndTheBroadcastUnderItsPrefix)
{
    EXPECT_TRUE(isAddressedTo(0x8001, 1, 0));
    EXPECT_TRUE(isAddressedTo(0x807f, 1, 0));
    EXPECT_FALSE(isAddressedTo(0x8002, 1, 0));
    EXPECT_FALSE(isAddressedTo(0x8081, 1, 0));  // bit 7 must be clear
    EXPECT_FALSE(isAddressedTo(0x18001, 1, 0));
    EXPECT_TRUE(isAddressedTo(0x18001, 1, 1));
}

TEST(MoteusArbitration, PayloadsArePaddedWithNops)
{
    const std::vector<std::uint8_t> payload(9, 0x11);
    const CanFrame frame = makeFrame({}, payload);
    EXPECT_EQ(toHex(frame.payload()), "111111111111111111505050");
}

}  // namespace
}  // namespace boresight::moteus
