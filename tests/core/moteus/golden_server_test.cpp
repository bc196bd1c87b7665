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

// The console text that waits in the recorded drive. It is not recorded, but follows from the response. A packet with
// flow control stays until the next one is requested. A full chunk means that more text was waiting.
class RecordedConsole
{
public:
    [[nodiscard]] std::string waitingBefore(const QJsonObject& vector)
    {
        const auto reply = decodeReply(golden::frame(0x100, golden::bytes(vector, "response")));
        if (!reply || reply->texts.empty()) {
            return m_held;
        }
        const TunnelText& answer = reply->texts.front();
        const bool repeated = answer.number && answer.number == m_lastNumber;
        const std::string more = answer.text.size() >= kFullChunk ? "and more than one chunk can hold" : "";
        const std::string waiting = (repeated || !answer.number ? "" : m_held) + answer.text + more;
        if (answer.number) {
            m_lastNumber = answer.number;
        }
        m_held = answer.number ? answer.text : "";
        return waiting;
    }

private:
    static constexpr std::size_t kFullChunk = 38;
    std::string m_held;
    std::optional<std::uint8_t> m_lastNumber;
};

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

bool isTunnel(const QJsonObject& vector)
{
    return golden::bytes(vector, "request").front() >> 4 == 4;
}

// The tunnel cases at the end are one conversation, so one server plays all cases.
// REQ-MOTEUS-03: A drive answers the recorded requests with the recorded replies, accepts the recorded writes, and is
// silent where the recording is silent.
TEST(GoldenServer, AnswersAsRecorded)
{
    FrameServer server;
    RecordedConsole console;
    for (const QJsonValue& value : golden::vectors("server")) {
        const QJsonObject vector = value.toObject();
        SCOPED_TRACE(golden::text(vector, "name") + ' ' + golden::text(vector, "note"));
        RecordingDevice device = deviceOf(vector);
        if (isTunnel(vector)) {
            device.text = console.waitingBefore(vector);
        }
        const DeviceAddress address{.id = static_cast<std::uint8_t>(vector[QLatin1String("device_id")].toInt()),
                                    .prefix = 0};
        const std::uint32_t id = golden::hexNumber(vector[QLatin1String("arbitration_id")]);
        expectResponse(vector, server.serve(golden::frame(id, golden::bytes(vector, "request")), address, device));
        expectWrites(vector, device);
    }
}

}  // namespace
}  // namespace boresight::moteus
