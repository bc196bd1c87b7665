// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus/codec.h"
#include "core/moteus/frame_server.h"
#include "tests/core/moteus/golden.h"
#include "tests/core/moteus/recording_device.h"

#include <gtest/gtest.h>

#include <cmath>

namespace boresight::moteus {
namespace {

using golden::toHex;

RecordingDevice deviceOf(const QJsonObject& vector)
{
    RecordingDevice device;
    const QJsonObject registers = vector[QLatin1String("registers")].toObject();
    for (auto it = registers.begin(); it != registers.end(); ++it) {
        device.registers[golden::registerNumber(it.key())] = golden::number(it.value());
    }
    return device;
}

// The recording does not say what text was waiting in the drive; the response does. A full chunk left some behind.
void provideText(const QJsonObject& vector, RecordingDevice& device)
{
    device.text.clear();
    const auto reply = decodeReply(golden::frame(0x100, golden::bytes(vector, "response")));
    ASSERT_TRUE(reply);
    for (const TunnelText& part : reply->texts) {
        device.text += part.text;
    }
    if (device.text.size() >= 38) {
        device.text += "and more than one chunk can hold";
    }
}

void expectWrites(const QJsonObject& vector, const RecordingDevice& device)
{
    const QJsonArray expected = vector[QLatin1String("writes")].toArray();
    ASSERT_EQ(static_cast<qsizetype>(device.writes.size()), expected.size());
    for (qsizetype i = 0; i < expected.size(); ++i) {
        const QJsonObject item = expected[i].toObject();
        const auto& [reg, actual] = device.writes[static_cast<std::size_t>(i)];
        EXPECT_EQ(reg, golden::registerNumber(item[QLatin1String("reg")].toString()));
        const double value = golden::number(item[QLatin1String("value")]);
        EXPECT_TRUE(static_cast<float>(value) == static_cast<float>(actual) ||
                    (std::isnan(value) && std::isnan(actual)))
            << value << " arrived as " << actual;
    }
}

void expectResponse(const QJsonObject& vector, const std::optional<CanFrame>& reply)
{
    const QJsonValue expected = vector[QLatin1String("response_wire")];
    if (!expected.isString()) {
        EXPECT_FALSE(reply) << toString(*reply);
        return;
    }
    ASSERT_TRUE(reply);
    EXPECT_EQ(toHex(reply->payload()), expected.toString().toStdString());
    EXPECT_EQ(reply->id, golden::hexNumber(vector[QLatin1String("response_arbitration_id")]));
    EXPECT_EQ(reply->extended, reply->id > kMaxStandardId);
}

// The tunnel cases at the end are one conversation, so one server plays them all.
TEST(GoldenServer, AnswersAsRecorded)
{
    FrameServer server;
    RecordingDevice tunnel;
    for (const QJsonValue& value : golden::vectors("server")) {
        const QJsonObject vector = value.toObject();
        SCOPED_TRACE(golden::text(vector, "name") + ' ' + golden::text(vector, "note"));
        const bool isTunnel = golden::bytes(vector, "request").front() >> 4 == 4;
        RecordingDevice device = deviceOf(vector);
        RecordingDevice& served = isTunnel ? tunnel : device;
        // A repeated packet must come from what is still waiting, not from a fresh supply.
        if (isTunnel && !golden::text(vector, "note").ends_with("retransmission")) {
            provideText(vector, tunnel);
        }
        const DeviceAddress address{.id = static_cast<std::uint8_t>(vector[QLatin1String("device_id")].toInt()),
                                    .prefix = 0};
        const std::uint32_t id = golden::hexNumber(vector[QLatin1String("arbitration_id")]);
        const auto reply = server.serve(golden::frame(id, golden::bytes(vector, "request")), address, served);
        expectResponse(vector, reply);
        expectWrites(vector, served);
    }
}

}  // namespace
}  // namespace boresight::moteus
