// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/orientation/json_payload.h"

#include <gtest/gtest.h>

#include <random>

namespace boresight::orientation {
namespace {

using std::chrono::seconds;

// In the form that the firmware prints, with its runs of spaces.
const QByteArray kOrientation =
    R"({  "dateTime": "Thursday, 19-Feb-2026 09:32:40 UTC",  "ts": "1771493560427",  "azimuth": -12.67,  "elevation": 19.13,  "revolutions": -1,  "units": {    "ts": "milliseconds",    "orientation": "decimal degrees"  }})";
const QByteArray kStatus =
    R"({  "dateTime": "Thursday, 19-Feb-2026 09:35:11 UTC",  "ts": "1771493711925",  "version": "2.0.6b",  "bssid": "B8:69:F4:81:8D:E6",  "temperatureC": 27})";
const QByteArray kCalibration =
    R"({  "dateTime": "Thursday, 19-Feb-2026 09:37:37 UTC",  "ts": "1771493857399",  "system": 0,  "gyro": 3,  "accelerometer": 1,  "magnetometer": 2})";

SteadyTime at(int second)
{
    return SteadyTime{seconds(second)};
}

QByteArray with(QByteArray message, const char* old, const char* now)
{
    EXPECT_TRUE(message.contains(old)) << old;
    return message.replace(old, now);
}

std::string reasonOf(const QByteArray& payload)
{
    const auto value = parseOrientation(payload, at(0));
    return value ? "accepted" : toText(value.error());
}

// REQ-ORIENTATION-05 (JsonPayload.*): The JSON of the three topics is read, with the time as text or number. "nan" is
// refused. Calibration and temperature are added to the next orientation while they are recent.
TEST(JsonPayload, TheOrientationOfTheFirmwareIsRead)
{
    const auto value = parseOrientation(kOrientation, at(3));
    ASSERT_TRUE(value) << toText(value.error());
    EXPECT_NEAR(value->extendedAzimuth.degrees(), -12.67, 1e-9);
    EXPECT_NEAR(value->heading.angle().degrees(), 347.33, 1e-9);
    EXPECT_NEAR(value->elevation.degrees(), 19.13, 1e-9);
    EXPECT_EQ(value->revolutions, -1);
    EXPECT_EQ(value->sensorTime.time_since_epoch(), std::chrono::milliseconds(1771493560427));
    EXPECT_EQ(value->arrival, at(3));
    EXPECT_EQ(value->transport, Transport::Mqtt);
    EXPECT_EQ(value->unknown, "");
}

TEST(JsonPayload, TheTimeMayBeANumber)
{
    const auto value = parseOrientation(with(kOrientation, "\"1771493560427\"", "1771493560427"), at(0));
    ASSERT_TRUE(value);
    EXPECT_EQ(value->sensorTime.time_since_epoch(), std::chrono::milliseconds(1771493560427));
}

TEST(JsonPayload, WhatMakesNoSenseIsRefusedWithItsReason)
{
    EXPECT_EQ(reasonOf(with(kOrientation, "-12.67", "nan")), "no JSON");
    EXPECT_EQ(reasonOf(with(kOrientation, "19.13", "inf")), "no JSON");
    EXPECT_EQ(reasonOf(with(kOrientation, "-12.67", "\"-12.67\"")), "azimuth is not a number");
    EXPECT_EQ(reasonOf(with(kOrientation, "-12.67", "1e300")), "azimuth out of range");
    EXPECT_EQ(reasonOf(with(kOrientation, "19.13", "180.5")), "elevation out of range");
    EXPECT_EQ(reasonOf(with(kOrientation, "\"revolutions\": -1", "\"revolutions\": 0.5")),
              "revolutions is not a number");
    EXPECT_EQ(reasonOf(with(kOrientation, "\"revolutions\": -1", "\"revolutions\": null")),
              "revolutions is not a number");
    EXPECT_EQ(reasonOf(with(kOrientation, "\"azimuth\"", "\"azimut\"")), "azimuth is missing");
    EXPECT_EQ(reasonOf(with(kOrientation, "\"ts\": \"1", "\"tx\": \"1")), "time is missing");
    EXPECT_EQ(reasonOf(with(kOrientation, "1771493560427", "yesterday")), "time is not a number");
    EXPECT_EQ(reasonOf(with(kOrientation, "decimal degrees", "radians")), "unit");
    for (const char* const bad : {"", "{", "[1]", "17", "null", "\"text\"", "{}x"}) {
        EXPECT_EQ(reasonOf(bad), "no JSON") << bad;
    }
    EXPECT_NE(reasonOf("{}"), "accepted");
}

TEST(JsonPayload, NoPartOfAMessageIsEnough)
{
    for (qsizetype size = 0; size < kOrientation.size(); ++size) {
        EXPECT_EQ(reasonOf(kOrientation.left(size)), "no JSON") << size;
    }
}

TEST(JsonPayload, WhatAnotherFirmwareAddsIsKept)
{
    const auto value = parseOrientation(with(kOrientation, "\"units\"", "\"roll\": 1.5, \"units\""), at(0));
    ASSERT_TRUE(value);
    EXPECT_EQ(value->unknown, "{\"roll\":1.5}");
}

TEST(JsonPayload, CalibrationDigitsAreZeroToThree)
{
    EXPECT_EQ(parseCalibration(kCalibration),
              (Calibration{.system = 0, .gyro = 3, .accelerometer = 1, .magnetometer = 2}));
    EXPECT_FALSE(parseCalibration(with(kCalibration, "\"gyro\": 3", "\"gyro\": 4")));
    EXPECT_FALSE(parseCalibration(with(kCalibration, "\"gyro\": 3", "\"gyro\": 1.5")));
    EXPECT_FALSE(parseCalibration(with(kCalibration, "\"gyro\": 3,", "")));
}

TEST(JsonPayload, TheStatusMayLackItsVersion)
{
    EXPECT_EQ(parseStatus(kStatus),
              (SensorState{.temperature = 27.0, .version = "2.0.6b", .bssid = "B8:69:F4:81:8D:E6"}));
    EXPECT_EQ(parseStatus(with(kStatus, "\"version\": \"2.0.6b\",", "")),
              (SensorState{.temperature = 27.0, .version = "", .bssid = "B8:69:F4:81:8D:E6"}));
    EXPECT_FALSE(parseStatus(with(kStatus, "27", "\"warm\"")));
}

// REQ-ORIENTATION-970: Unknown keys of a status message are kept for display, up to a fixed length, and the message is
// used.
TEST(JsonPayload, TheStatusKeepsWhatNobodyKnows)
{
    const auto state = parseStatus(with(kStatus, "{", "{ \"rssi\": -71, \"uptime\": \"3 d\","));
    ASSERT_TRUE(state);
    EXPECT_EQ(state->unknown, "{\"rssi\":-71,\"uptime\":\"3 d\"}");
    EXPECT_EQ(state->version, "2.0.6b");
    const QByteArray much = "{\"x\": \"" + QByteArray(5000, 'y') + "\",";
    EXPECT_LE(parseStatus(with(kStatus, "{", much))->unknown.size(), 400U);
}

bool bringsNothing(const Parsed<std::optional<Orientation>>& taken)
{
    return taken && !*taken;
}

// REQ-ORIENTATION-05 (PayloadReader.*)
TEST(PayloadReader, JoinsWhatTheOtherTopicsSaidWhileItIsYoung)
{
    PayloadReader reader;
    const auto alone = reader.take(Topic::Orientation, kOrientation, at(0));
    ASSERT_TRUE(alone && *alone);
    EXPECT_FALSE((*alone)->calibration);
    EXPECT_FALSE((*alone)->temperature);

    EXPECT_TRUE(bringsNothing(reader.take(Topic::Calibration, kCalibration, at(1))));
    EXPECT_TRUE(bringsNothing(reader.take(Topic::Status, kStatus, at(1))));
    EXPECT_EQ(reader.firmware(), "2.0.6b");
    const auto joined = reader.take(Topic::Orientation, kOrientation, at(31));
    ASSERT_TRUE(joined && *joined);
    EXPECT_EQ((*joined)->calibration->magnetometer, 2);
    EXPECT_EQ((*joined)->temperature, 27.0);

    const auto old = reader.take(Topic::Orientation, kOrientation, at(32));
    ASSERT_TRUE(old && *old);
    EXPECT_FALSE((*old)->calibration);
    EXPECT_EQ((*old)->temperature, 27.0);
    EXPECT_FALSE((*reader.take(Topic::Orientation, kOrientation, at(182)))->temperature);
    EXPECT_EQ(reader.counts().accepted, 6U);
}

TEST(PayloadReader, CountsWhatItRefuses)
{
    PayloadReader reader;
    EXPECT_FALSE(reader.take(Topic::Orientation, with(kOrientation, "-12.67", "nan"), at(0)));
    EXPECT_FALSE(reader.take(Topic::Calibration, "x", at(0)));
    EXPECT_EQ(reader.counts().of(Refusal::NotJson), 2U);
    EXPECT_EQ(reader.counts().accepted, 0U);
}

TEST(PayloadReader, GarbageIsSurvived)
{
    std::mt19937 random(7);
    PayloadReader reader;
    for (int round = 0; round < 5000; ++round) {
        QByteArray damaged = kOrientation;
        for (int change = 0; change < 3; ++change) {
            damaged[static_cast<qsizetype>(random() % static_cast<unsigned>(damaged.size()))] =
                static_cast<char>(random() % 256);
        }
        const auto value = reader.take(Topic::Orientation, damaged, at(0));
        ASSERT_TRUE(!value || ((*value)->elevation <= 180_deg && (*value)->elevation >= 0_deg)) << damaged.constData();
    }
    EXPECT_EQ(reader.counts().accepted + reader.counts().allRefused(), 5000U);
}

}  // namespace
}  // namespace boresight::orientation
