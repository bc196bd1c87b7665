// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus/codec.h"
#include "tests/core/moteus/golden.h"
#include "tests/fakes/text_of.h"

#include <QHash>

#include <gtest/gtest.h>

#include <cmath>

namespace boresight::moteus {
namespace {

using golden::toHex;

// The recorded fields of one command, with the resolutions in which they are sent.
class Fields
{
public:
    explicit Fields(const QJsonObject& vector)
        : m_values(vector[QLatin1String("fields")].toObject()), m_formats(vector[QLatin1String("formats")].toObject())
    {}
    [[nodiscard]] std::optional<Field> operator[](const char* name) const
    {
        const QLatin1String key(name);
        if (!m_values.contains(key)) {
            return std::nullopt;
        }
        return Field{golden::number(m_values[key]), golden::resolution(m_formats[key].toString())};
    }
    [[nodiscard]] QJsonValue raw(const char* name) const { return m_values[QLatin1String(name)]; }
    [[nodiscard]] const QJsonObject& formats() const { return m_formats; }

private:
    QJsonObject m_values;
    QJsonObject m_formats;
};

PositionCommand positionCommand(const Fields& f)
{
    return {.position = f["position"],
            .velocity = f["velocity"],
            .feedforwardTorque = f["feedforward_torque"],
            .kpScale = f["kp_scale"],
            .kdScale = f["kd_scale"],
            .maximumTorque = f["maximum_torque"],
            .stopPosition = f["stop_position"],
            .watchdogTimeout = f["watchdog_timeout"],
            .velocityLimit = f["velocity_limit"],
            .accelerationLimit = f["accel_limit"],
            .fixedVoltage = f["fixed_voltage_override"],
            .integralLimitScale = f["ilimit_scale"],
            .fixedCurrent = f["fixed_current_override"],
            .ignorePositionBounds = f["ignore_position_bounds"]};
}

StayWithin stayWithin(const Fields& f)
{
    return {.lower = f["lower_bound"],
            .upper = f["upper_bound"],
            .feedforwardTorque = f["feedforward_torque"],
            .kpScale = f["kp_scale"],
            .kdScale = f["kd_scale"],
            .maximumTorque = f["maximum_torque"],
            .watchdogTimeout = f["watchdog_timeout"],
            .integralLimitScale = f["ilimit_scale"],
            .ignorePositionBounds = f["ignore_position_bounds"]};
}

using MakeCommand = Command (*)(const Fields&);

const QHash<QString, MakeCommand>& commandsByName()
{
    static const QHash<QString, MakeCommand> commands{
        {QStringLiteral("stop"), [](const Fields&) -> Command { return Stop{}; }},
        {QStringLiteral("brake"), [](const Fields&) -> Command { return Brake{}; }},
        {QStringLiteral("zero_velocity"), [](const Fields& f) -> Command { return ZeroVelocity{f["kd_scale"]}; }},
        {QStringLiteral("position"), [](const Fields& f) -> Command { return positionCommand(f); }},
        {QStringLiteral("stay_within"), [](const Fields& f) -> Command { return stayWithin(f); }},
        {QStringLiteral("current"),
         [](const Fields& f) -> Command { return CurrentCommand{.q = f["q_A"], .d = f["d_A"]}; }},
        {QStringLiteral("vfoc"),
         [](const Fields& f) -> Command {
             return VoltageFocCommand{
                 .theta = f["theta_rad"], .voltage = f["voltage"], .thetaRate = f["theta_rad_rate"]};
         }},
        {QStringLiteral("set_output_nearest"),
         [](const Fields& f) -> Command { return SetOutputNearest{f["position"].value()}; }},
        {QStringLiteral("set_output_exact"),
         [](const Fields& f) -> Command { return SetOutputExact{f["position"].value()}; }},
        {QStringLiteral("require_reindex"), [](const Fields&) -> Command { return RequireReindex{}; }},
        {QStringLiteral("recapture_position_velocity"),
         [](const Fields&) -> Command { return RecapturePositionVelocity{}; }},
        {QStringLiteral("clock_trim"), [](const Fields& f) -> Command { return ClockTrim{f["trim"].value()}; }},
    };
    return commands;
}

// JSON objects are sorted by key. For the recorded names this is not the order of the registers.
Query queryOf(const QJsonObject& formats)
{
    Query query;
    for (auto it = formats.begin(); it != formats.end(); ++it) {
        query.push_back({golden::registerNumber(it.key()), golden::resolution(it.value().toString())});
    }
    std::ranges::sort(query, {}, &RegisterRead::reg);
    return query;
}

bool isTunnel(const QString& op)
{
    return op.startsWith(QLatin1String("diagnostic_"));
}

Request requestOf(const QJsonObject& vector)
{
    const Fields fields(vector);
    const QString op = vector[QLatin1String("op")].toString();
    Request request;
    request.destination = static_cast<std::uint8_t>(vector[QLatin1String("id")].toInt());
    request.source = static_cast<std::uint8_t>(vector[QLatin1String("source")].toInt());
    request.prefix = static_cast<std::uint16_t>(vector[QLatin1String("prefix")].toInt());
    request.replyWanted = vector[QLatin1String("reply")].toBool();
    if (op == QLatin1String("query_registers")) {
        request.query = queryOf(fields.formats());
        return request;
    }
    request.query = queryOf(vector[QLatin1String("query")].toObject());
    if (const auto make = commandsByName().value(op)) {
        request.command = make(fields);
    } else {
        EXPECT_EQ(op.toStdString(), "query") << "an unknown command";
    }
    return request;
}

template <class Check>
void forEachRegisterCommand(Check check)
{
    for (const QJsonValue& value : golden::vectors("commands")) {
        const QJsonObject vector = value.toObject();
        if (!isTunnel(vector[QLatin1String("op")].toString())) {
            SCOPED_TRACE(golden::text(vector, "name"));
            check(vector, requestOf(vector));
        }
    }
}

// REQ-MOTEUS-01 (GoldenCommands.*): Commands are encoded to exactly the recorded bytes, identifier and padding, and can
// be read back.
TEST(GoldenCommands, EncodeToTheRecordedFrames)
{
    forEachRegisterCommand([](const QJsonObject& vector, const Request& request) {
        const auto frame = encode(request);
        if (const auto answerable = checkAnswerable(request.query); !answerable) {
            // The recorded client sends queries whose last part the drive leaves out. Ours refuses them and gives the
            // reason.
            ASSERT_FALSE(frame);
            EXPECT_EQ(frame.error(), answerable.error());
            return;
        }
        ASSERT_TRUE(frame) << textOf(frame.error());
        EXPECT_EQ(toHex(frame->payload()), golden::text(vector, "wire"));
        EXPECT_EQ(frame->id, golden::hexNumber(vector[QLatin1String("arbitration_id")]));
        EXPECT_EQ(frame->extended, vector[QLatin1String("extended")].toBool());
        EXPECT_TRUE(frame->flexibleData);
        EXPECT_TRUE(frame->bitRateSwitch);
    });
}

TEST(GoldenCommands, BuildTheRecordedPayloadAndReplySize)
{
    forEachRegisterCommand([](const QJsonObject& vector, const Request& request) {
        SubframeWriter writer;
        if (request.command) {
            writer.appendWrites(registerWrites(*request.command));
        }
        writer.appendReads(request.query);
        EXPECT_EQ(toHex(writer.bytes()), golden::text(vector, "payload"));
        EXPECT_EQ(static_cast<int>(replySize(request.query)), vector[QLatin1String("reply_size")].toInt());
    });
}

// The value that arrives is the commanded value, or less by under one step, or saturated, or unset.
void expectArrived(const RegisterValue& sent, const RegisterValue& arrived)
{
    EXPECT_EQ(sent.reg, arrived.reg);
    EXPECT_EQ(sent.resolution, arrived.resolution);
    if (sent.resolution == Resolution::Float) {
        EXPECT_TRUE(static_cast<float>(sent.value) == static_cast<float>(arrived.value) ||
                    (std::isnan(sent.value) && std::isnan(arrived.value)));
        return;
    }
    if (!std::isfinite(sent.value)) {
        EXPECT_TRUE(std::isnan(arrived.value));
        return;
    }
    const double step = stepSize(*registerKind(sent.reg), sent.resolution);
    const double largest = std::ldexp(1.0, static_cast<int>(8 * sizeInBytes(sent.resolution)) - 1) - 1;
    const double expected = std::clamp(sent.value, -largest * step, largest * step);
    EXPECT_LE(std::abs(arrived.value), std::abs(expected) * (1 + 1e-12));
    EXPECT_LT(std::abs(expected - arrived.value), step);
}

TEST(GoldenCommands, DecodeBackToTheCommandedRegisters)
{
    forEachRegisterCommand([](const QJsonObject& vector, const Request& request) {
        std::vector<RegisterValue> writes;
        Query reads;
        const auto wire = golden::bytes(vector, "wire");
        SubframeReader reader(wire);
        while (const auto subframe = reader.next()) {
            if (const auto* write = std::get_if<WriteBlock>(&*subframe)) {
                for (std::uint32_t i = 0; i < write->count; ++i) {
                    writes.push_back(write->value(i));
                }
            } else if (const auto* read = std::get_if<ReadBlock>(&*subframe)) {
                for (std::uint32_t i = 0; i < read->count; ++i) {
                    reads.push_back({read->first + i, read->resolution});
                }
            } else {
                EXPECT_TRUE(std::holds_alternative<Nop>(*subframe));
            }
        }
        EXPECT_EQ(reader.end(), ParseEnd::Complete);
        EXPECT_EQ(reads, request.query);
        const auto sent = request.command ? registerWrites(*request.command) : std::vector<RegisterValue>{};
        ASSERT_EQ(writes.size(), sent.size());
        for (std::size_t i = 0; i < sent.size(); ++i) {
            expectArrived(sent[i], writes[i]);
        }
    });
}

Subframe tunnelSubframe(const QString& op, const Fields& fields, std::span<const std::uint8_t> text)
{
    const auto channel = static_cast<std::uint32_t>(fields.raw("channel").toInt());
    const auto maximum = static_cast<std::uint32_t>(fields.raw("max_length").toInt());
    if (op == QLatin1String("diagnostic_write")) {
        return TunnelToDevice{channel, text};
    }
    if (op == QLatin1String("diagnostic_read")) {
        return TunnelPoll{channel, maximum};
    }
    return TunnelPollFlow{channel, static_cast<std::uint8_t>(fields.raw("packet_number").toInt()), maximum};
}

TEST(GoldenCommands, TunnelRequestsBuildTheRecordedFrames)
{
    int seen = 0;
    for (const QJsonValue& value : golden::vectors("commands")) {
        const QJsonObject vector = value.toObject();
        const QString op = vector[QLatin1String("op")].toString();
        if (!isTunnel(op)) {
            continue;
        }
        SCOPED_TRACE(golden::text(vector, "name"));
        ++seen;
        const Fields fields(vector);
        const QByteArray text = fields.raw("text").toString().toLatin1();
        const std::vector<std::uint8_t> textBytes(text.begin(), text.end());
        SubframeWriter writer;
        writer.append(tunnelSubframe(op, fields, textBytes));
        const CanFrame frame =
            makeFrame({.replyWanted = vector[QLatin1String("reply")].toBool(),
                       .destination = static_cast<std::uint8_t>(vector[QLatin1String("id")].toInt())},
                      writer.bytes());
        EXPECT_EQ(toHex(writer.bytes()), golden::text(vector, "payload"));
        EXPECT_EQ(toHex(frame.payload()), golden::text(vector, "wire"));
        EXPECT_EQ(frame.id, golden::hexNumber(vector[QLatin1String("arbitration_id")]));
    }
    EXPECT_GT(seen, 0);
}

}  // namespace
}  // namespace boresight::moteus
