// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus/codec.h"
#include "tests/core/moteus/golden.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

namespace boresight::moteus {
namespace {

using golden::toHex;

Reply decoded(const QJsonObject& vector)
{
    const std::uint32_t id = golden::hexNumber(vector[QLatin1String("arbitration_id")]);
    const auto reply = decodeReply(golden::frame(id, golden::bytes(vector, "payload")));
    EXPECT_TRUE(reply);
    return reply.value_or(Reply{});
}

void expectSame(double expected, double actual)
{
    if (std::isfinite(expected)) {
        EXPECT_NEAR(actual, expected, 1e-12 * std::abs(expected));
    } else {
        EXPECT_EQ(std::bit_cast<std::uint32_t>(static_cast<float>(actual)) & 0x7fffffff,
                  std::bit_cast<std::uint32_t>(static_cast<float>(expected)) & 0x7fffffff);
        EXPECT_TRUE(std::isnan(expected) || std::signbit(actual) == std::signbit(expected));
    }
}

// REQ-MOTEUS-02 (GoldenReplies.*): Recorded replies are decoded to their values and encoded back. Every recorded frame,
// split into subframes, is written back byte for byte.
TEST(GoldenReplies, DecodeToTheRecordedValues)
{
    for (const QJsonValue& value : golden::vectors("replies")) {
        const QJsonObject vector = value.toObject();
        SCOPED_TRACE(golden::text(vector, "name") + ' ' + golden::text(vector, "note"));
        const Reply reply = decoded(vector);
        EXPECT_EQ(reply.source, vector[QLatin1String("id")].toInt());
        const QJsonArray expected = vector[QLatin1String("decoded")].toArray();
        ASSERT_EQ(static_cast<qsizetype>(reply.values.size()), expected.size());
        for (qsizetype i = 0; i < expected.size(); ++i) {
            const QJsonObject item = expected[i].toObject();
            const RegisterValue& actual = reply.values[static_cast<std::size_t>(i)];
            EXPECT_EQ(actual.reg, golden::registerNumber(item[QLatin1String("reg")].toString()));
            EXPECT_EQ(actual.resolution, golden::resolution(item[QLatin1String("format")].toString()));
            expectSame(golden::number(item[QLatin1String("value")]), actual.value);
        }
    }
}

// The recorded values, encoded as by a drive, give the recorded payload: the same blocks, with each integer at most one
// step away. (Truncation affects values that are not exact in binary.)
TEST(GoldenReplies, EncodeBackToTheRecordedBlocks)
{
    int checked = 0;
    for (const QJsonValue& value : golden::vectors("replies")) {
        const QJsonObject vector = value.toObject();
        SCOPED_TRACE(golden::text(vector, "name"));
        const Reply reply = decoded(vector);
        SubframeWriter writer;
        writer.appendReplies(reply.values);
        ASSERT_FALSE(writer.overflowed());
        const auto again = decodeReply(golden::frame(0x100, {writer.bytes().begin(), writer.bytes().end()}));
        ASSERT_TRUE(again);
        ASSERT_EQ(again->values.size(), reply.values.size());
        for (std::size_t i = 0; i < reply.values.size(); ++i) {
            const RegisterValue& before = reply.values[i];
            const RegisterValue& after = again->values[i];
            EXPECT_EQ(after.reg, before.reg);
            const double step = stepSize(registerKind(before.reg).value(), before.resolution);
            const double coarse = before.resolution == Resolution::Int32 ? 1e-6 * std::abs(before.value) : 0.0;
            EXPECT_TRUE((std::isnan(before.value) && std::isnan(after.value)) || before.value == after.value ||
                        std::abs(before.value - after.value) <= step * (1 + 1e-9) + coarse)
                << before.value << " became " << after.value;
            ++checked;
        }
    }
    EXPECT_GT(checked, 0);
}

TEST(GoldenReplies, SubframesWriteBackByteForByte)
{
    for (const CanFrame& frame : golden::allFrames()) {
        SCOPED_TRACE(toString(frame));
        SubframeReader reader(frame.payload());
        SubframeWriter writer;
        while (const auto subframe = reader.next()) {
            if (reader.end() == ParseEnd::Complete) {
                writer.append(*subframe);
            }
        }
        const std::string whole = toHex(frame.payload());
        EXPECT_EQ(toHex(writer.bytes()), whole.substr(0, 2 * writer.needed()));
        if (reader.end() == ParseEnd::Complete) {
            EXPECT_EQ(writer.needed(), frame.size);
        }
    }
}

TEST(GoldenReplies, TunnelTextArrives)
{
    for (const QJsonValue& value : golden::vectors("diagnostic_replies")) {
        const QJsonObject vector = value.toObject();
        SCOPED_TRACE(golden::text(vector, "name"));
        const auto reply = decodeReply(golden::frame(0x100, golden::bytes(vector, "payload")));
        ASSERT_TRUE(reply);
        TunnelText expected;
        expected.channel = static_cast<std::uint32_t>(vector[QLatin1String("channel")].toInt());
        expected.text = golden::text(vector, "text");
        if (golden::text(vector, "kind") == "flow") {
            expected.number = static_cast<std::uint8_t>(vector[QLatin1String("packet_number")].toInt());
        }
        EXPECT_EQ(reply->texts, std::vector<TunnelText>{expected});
        EXPECT_EQ(reply->end, ParseEnd::Complete);
    }
}

}  // namespace
}  // namespace boresight::moteus
