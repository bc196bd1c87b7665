// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/moteus/golden.h"

#include <QFile>
#include <QHash>
#include <QJsonDocument>

#include <gtest/gtest.h>

#include <limits>

namespace boresight::moteus::golden {
namespace {

QJsonObject load()
{
    const QString path =
        qEnvironmentVariable("MOTEUS_GOLDEN", QStringLiteral(BORESIGHT_TEST_DATA "/moteus_golden.json"));
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        ADD_FAILURE() << "cannot read " << path.toStdString();
        return {};
    }
    QJsonParseError error;
    const QJsonObject root = QJsonDocument::fromJson(file.readAll(), &error).object();
    EXPECT_EQ(error.error, QJsonParseError::NoError) << path.toStdString();
    return root;
}

const QJsonObject& file()
{
    static const QJsonObject root = load();
    return root;
}

}  // namespace

QJsonArray vectors(const char* list)
{
    const QJsonArray array = file()[QLatin1String(list)].toArray();
    EXPECT_FALSE(array.isEmpty()) << "no vectors in \"" << list << '"';
    return array;
}

std::string text(const QJsonObject& object, const char* key)
{
    return object[QLatin1String(key)].toString().toStdString();
}

std::vector<std::uint8_t> bytes(const QString& hex)
{
    const QByteArray raw = QByteArray::fromHex(hex.toLatin1());
    return {raw.begin(), raw.end()};
}

std::vector<std::uint8_t> bytes(const QJsonObject& object, const char* key)
{
    return bytes(object[QLatin1String(key)].toString());
}

std::uint32_t hexNumber(const QJsonValue& value)
{
    bool ok = false;
    const std::uint32_t result = value.toString().toUInt(&ok, 16);
    EXPECT_TRUE(ok) << value.toString().toStdString();
    return result;
}

double number(const QJsonValue& value)
{
    if (!value.isString()) {
        return value.toDouble();
    }
    const double infinity = std::numeric_limits<double>::infinity();
    const QString text = value.toString();
    return text == QLatin1String("inf") ? infinity : text == QLatin1String("-inf") ? -infinity : std::nan("");
}

Resolution resolution(const QString& text)
{
    for (const Resolution candidate : {Resolution::Int8, Resolution::Int16, Resolution::Int32, Resolution::Float}) {
        if (text.toStdString() == resolutionText(candidate)) {
            return candidate;
        }
    }
    ADD_FAILURE() << "unknown format " << text.toStdString();
    return Resolution::Float;
}

Register registerNumber(const QString& text)
{
    static const QHash<QString, Register> kNames{
        {QStringLiteral("mode"), Register::Mode},
        {QStringLiteral("position"), Register::Position},
        {QStringLiteral("velocity"), Register::Velocity},
        {QStringLiteral("torque"), Register::Torque},
        {QStringLiteral("q_current"), Register::QCurrent},
        {QStringLiteral("d_current"), Register::DCurrent},
        {QStringLiteral("abs_position"), Register::AbsolutePosition},
        {QStringLiteral("power"), Register::Power},
        {QStringLiteral("motor_temperature"), Register::MotorTemperature},
        {QStringLiteral("trajectory_complete"), Register::TrajectoryComplete},
        {QStringLiteral("home_state"), Register::HomeState},
        {QStringLiteral("voltage"), Register::Voltage},
        {QStringLiteral("temperature"), Register::Temperature},
        {QStringLiteral("fault"), Register::Fault},
    };
    const auto found = kNames.find(text);
    return found != kNames.end() ? *found : static_cast<Register>(hexNumber(QJsonValue(text)));
}

std::string toHex(std::span<const std::uint8_t> bytes)
{
    std::string result;
    for (const std::uint8_t byte : bytes) {
        static constexpr char kDigits[] = "0123456789abcdef";
        result += kDigits[byte >> 4];
        result += kDigits[byte & 15];
    }
    return result;
}

CanFrame frame(std::uint32_t id, const std::vector<std::uint8_t>& payload)
{
    CanFrame result;
    result.id = id;
    result.extended = id > kMaxStandardId;
    result.setPayload(payload);
    return result;
}

std::vector<CanFrame> allFrames()
{
    std::vector<CanFrame> frames;
    const auto collect = [&frames](const char* list, const char* id, const char* payload) {
        for (const QJsonValue& value : vectors(list)) {
            const QJsonObject object = value.toObject();
            if (object[QLatin1String(payload)].isString()) {
                frames.push_back(frame(hexNumber(object[QLatin1String(id)]), bytes(object, payload)));
            }
        }
    };
    collect("commands", "arbitration_id", "wire");
    collect("replies", "arbitration_id", "payload");
    collect("server", "arbitration_id", "request");
    collect("server", "response_arbitration_id", "response_wire");
    for (const QJsonValue& value : vectors("diagnostic_replies")) {
        frames.push_back(frame(0x100, bytes(value.toObject(), "payload")));
    }
    return frames;
}

}  // namespace boresight::moteus::golden
