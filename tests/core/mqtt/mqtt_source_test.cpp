// SPDX-License-Identifier: GPL-3.0-or-later
// The sensor's messages through a real broker.
#include "core/orientation_stream/mqtt_source.h"

#include "tests/core/mqtt/mqtt_rig.h"
#include "tests/fakes/mqtt_test.h"

#include <gmock/gmock.h>

namespace boresight::orientation {
namespace {

using mqtt::Rig;
using testing::ElementsAre;
using testing::HasSubstr;
constexpr auto npos = std::string::npos;

// In the form that the firmware prints, with its runs of spaces.
const QByteArray kOrientation =
    R"({  "dateTime": "Thursday, 19-Feb-2026 09:32:40 UTC",  "ts": "1771493560427",  "azimuth": 372.67,  )"
    R"("elevation": 19.13,  "revolutions": 1,  "units": {    "ts": "milliseconds",    "orientation": "decimal degrees"  }})";
const QByteArray kStatus = R"({  "dateTime": "Thursday, 19-Feb-2026 09:35:11 UTC",  "ts": "1771493711925",  )"
                           R"("version": "2.0.6b",  "bssid": "B8:69:F4:81:8D:E6",  "temperatureC": 27})";
const QByteArray kCalibration = R"({  "dateTime": "Thursday, 19-Feb-2026 09:37:37 UTC",  "ts": "1771493857399",  )"
                                R"("system": 0,  "gyro": 3,  "accelerometer": 1,  "magnetometer": 2})";

class MqttSourceTest : public fakes::MqttTest
{
protected:
    void prepare() override { begin(Door::Open); }
    void begin(Door door)
    {
        ASSERT_TRUE(startBroker(door));
        sensor.client.open(mqtt::onLoopback(broker->port()));
        ASSERT_TRUE(sensor.connected());
    }
    void listen(std::chrono::milliseconds silence = std::chrono::seconds(5))
    {
        topics.silence = silence;
        source = std::make_unique<MqttSource>(station.client, topics, station.clock);
        QObject::connect(source.get(), &SensorSource::received, source.get(),
                         [this](const Orientation& value) { values.push_back(value); });
        QObject::connect(source.get(), &SensorSource::statusChanged, source.get(), [this](const SourceStatus& status) {
            states.push_back((status.open ? "open " : "closed ") + status.problem.toStdString());
        });
        source->open();
        station.client.open(mqtt::onLoopback(broker->port()));
        ASSERT_TRUE(station.connected());
    }
    void send(const char* topic, const QByteArray& payload)
    {
        EXPECT_TRUE(sensor.client.publish({.topic = QLatin1String(topic), .payload = payload}));
    }
    // From now on a guarded broker lets everybody read everything.
    void permitAll()
    {
        send(
            "$CONTROL/dynamic-security/v1",
            R"({"commands": [{"command": "setDefaultACLAccess", "acls": [{"acltype": "subscribe", "allow": true}]}]})");
        sensor.client.subscribe(QStringLiteral("done"));
        ASSERT_TRUE(fakes::waitUntil([this] {
            send("done", "");
            return !sensor.messages.empty();
        }));
    }
    [[nodiscard]] bool received(std::size_t count) const
    {
        return fakes::waitUntil([this, count] { return values.size() >= count; });
    }

    MqttTopics topics{.orientation = QStringLiteral("roof/orientation"),
                      .status = QStringLiteral("roof/status"),
                      .calibration = QStringLiteral("roof/calibration")};
    Rig sensor;
    Rig station;
    std::vector<Orientation> values;
    std::vector<std::string> states;
    std::unique_ptr<MqttSource> source;
};

TEST_F(MqttSourceTest, JoinsWhatTheThreeTopicsSay)
{
    listen();
    EXPECT_EQ(source->name(), QStringLiteral("MQTT 127.0.0.1:%1").arg(broker->port()));
    send("roof/orientation", kOrientation);
    ASSERT_TRUE(received(1));
    EXPECT_NEAR(values[0].heading.angle().degrees(), 12.67, 1e-9);
    EXPECT_NEAR(values[0].elevation.degrees(), 19.13, 1e-9);
    EXPECT_EQ(values[0].revolutions, 1);
    EXPECT_EQ(values[0].arrival, station.clock.now());
    EXPECT_EQ(values[0].transport, Transport::Mqtt);
    EXPECT_FALSE(values[0].calibration || values[0].temperature) << "the firmware does not send them any more";

    send("roof/status", kStatus);
    send("roof/calibration", kCalibration);
    send("roof/orientation", kOrientation);
    ASSERT_TRUE(received(2));
    EXPECT_EQ(values[1].temperature, 27.0);
    EXPECT_EQ(values[1].calibration, (Calibration{.system = 0, .gyro = 3, .accelerometer = 1, .magnetometer = 2}));
    EXPECT_THAT(states, ElementsAre("open "));
}

TEST_F(MqttSourceTest, WhatMakesNoSenseIsCountedAndNotUsed)
{
    listen();
    QByteArray notFinite = kOrientation;
    notFinite.replace("372.67", "nan");
    send("roof/orientation", notFinite);
    send("roof/orientation", "");
    send("roof/orientation", kOrientation);
    ASSERT_TRUE(received(1));
    EXPECT_EQ(values.size(), 1U);
    EXPECT_EQ(source->status().counts.accepted, 1U);
    EXPECT_EQ(source->status().counts.allRefused(), 2U);
}

// Story: a message that `mosquitto_pub -r` had left an hour ago was the present direction of the sensor at every
// connect.
// REQ-MQTT-09a: Retained messages are distinguished from live ones. A retained message of the sensor is counted and
// never used.
TEST_F(MqttSourceTest, WhatTheBrokerHasKeptIsNotLive)
{
    sensor.client.subscribe(QStringLiteral("roof/#"));
    sensor.client.publish(
        {.topic = QStringLiteral("roof/orientation"), .payload = kOrientation, .retain = mqtt::Retain::Yes});
    sensor.client.publish(
        {.topic = QStringLiteral("roof/calibration"), .payload = kCalibration, .retain = mqtt::Retain::Yes});
    ASSERT_TRUE(sensor.received(2));  // so the broker has them
    listen(std::chrono::seconds(1));
    ASSERT_TRUE(fakes::waitUntil([this] { return states.size() == 2; }));
    EXPECT_THAT(states.back(), HasSubstr("only an old stored value"));
    EXPECT_TRUE(values.empty());
    EXPECT_EQ(source->status().counts.of(Refusal::Retained), 2U);
    QByteArray now = kOrientation;
    now.replace("372.67", "12.00");
    // A publisher that uses the retain flag is live for clients that are connected at that time.
    sensor.client.publish({.topic = QStringLiteral("roof/orientation"), .payload = now, .retain = mqtt::Retain::Yes});
    ASSERT_TRUE(received(1));
    EXPECT_NEAR(values[0].heading.angle().degrees(), 12.0, 1e-9);
    EXPECT_FALSE(values[0].calibration);
    EXPECT_EQ(states.back(), "open ");
}

TEST_F(MqttSourceTest, SaysWhenNothingComesAndWhenItIsNothingOfTheSensor)
{
    listen(std::chrono::seconds(1));
    ASSERT_TRUE(fakes::waitUntil([this] { return states.size() == 2; }));
    EXPECT_THAT(states, ElementsAre("open ", HasSubstr("No data on roof/orientation")));
    send("roof/orientation", kOrientation);
    ASSERT_TRUE(received(1));
    EXPECT_EQ(states.back(), "open ");
    send("roof/orientation", "21.5");
    ASSERT_TRUE(fakes::waitUntil([this] { return states.size() == 4; }));
    EXPECT_THAT(states.back(), HasSubstr("The messages on roof/orientation are not from the sensor"));
}

// Story: the broker refused the topic, and the line said that the sensor may have no power.
// REQ-MQTT-09b: A subscription that the broker refuses is reported once, with its topic and the remedy, and requested
// again every 30 s.
TEST_F(MqttSourceTest, ATopicThatTheBrokerRefusesIsToldUntilItIsPermitted)
{
    if (!fakes::MqttBroker::canBeGuarded()) {
        GTEST_SKIP() << "mosquitto_dynamic_security.so is not there";
    }
    begin(Door::Guarded);
    topics.status = QStringLiteral("permitted/status");
    topics.calibration = QStringLiteral("permitted/calibration");
    listen(std::chrono::seconds(1));
    ASSERT_TRUE(fakes::waitUntil([this] { return states.size() == 2; }));
    EXPECT_THAT(states.back(), HasSubstr("open MQTT 127.0.0.1:"));
    EXPECT_THAT(
        states.back(),
        HasSubstr("The broker does not permit reading roof/orientation. Permit it in the access list (ACL) of the "
                  "broker, or set mqtt.user and mqtt.password"));
    send("roof/orientation", kOrientation);
    station.letTimePass(Seconds(60.0));
    ASSERT_TRUE(fakes::waitUntil([this] { return broker->count("roof/orientation (QoS 0)") == 2; })) << "asked again";
    EXPECT_EQ(states.size(), 2U) << "one line, and nothing comes";
    permitAll();
    station.letTimePass(Seconds(29.0));
    station.letTimePass(Seconds(1.0));
    ASSERT_TRUE(fakes::waitUntil([this] { return broker->count("roof/orientation (QoS 0)") == 3; }));
    ASSERT_TRUE(fakes::waitUntil([this] { return states.back().find("No data on roof/or") != npos; }))
        << "permitted, and waited for anew, without a message: " << states.back();
    send("roof/orientation", kOrientation);
    ASSERT_TRUE(received(1));
    EXPECT_EQ(states.back(), "open ");
    station.letTimePass(Seconds(60.0));
    send("roof/orientation", kOrientation);
    ASSERT_TRUE(received(2));
    EXPECT_EQ(broker->count("roof/orientation (QoS 0)"), 3) << "granted is granted";
}

// REQ-MQTT-09b
TEST_F(MqttSourceTest, ATopicBesideItThatIsRefusedIsToldAndTheRestWorks)
{
    if (!fakes::MqttBroker::canBeGuarded()) {
        GTEST_SKIP() << "mosquitto_dynamic_security.so is not there";
    }
    begin(Door::Guarded);
    topics.orientation = QStringLiteral("permitted/orientation");
    topics.status = QStringLiteral("permitted/status");
    listen();
    ASSERT_TRUE(fakes::waitUntil([this] { return states.size() == 2; }));
    EXPECT_THAT(states.back(), HasSubstr("does not permit reading roof/calibration"));
    send("permitted/orientation", kOrientation);
    ASSERT_TRUE(received(1));
    EXPECT_EQ(states.size(), 2U) << "as long as it lasts";
    permitAll();
    station.letTimePass(Seconds(30.0));
    ASSERT_TRUE(fakes::waitUntil([this] { return states.size() == 3; }));
    EXPECT_EQ(states.back(), "open ");
}

// mosquitto's own access list accepts the subscription and delivers nothing.
TEST_F(MqttSourceTest, AnAccessListThatKeepsQuietIsAmongTheCausesOfSilence)
{
    begin(Door::AccessList);
    listen(std::chrono::milliseconds(300));
    station.client.subscribe(QStringLiteral("permitted/mark"));
    ASSERT_TRUE(fakes::waitUntil([this] {
        send("roof/orientation", kOrientation);
        send("permitted/mark", "");
        return !station.messages.empty();
    }));
    EXPECT_TRUE(values.empty());
    ASSERT_TRUE(fakes::waitUntil([this] { return states.size() == 2; }));
    EXPECT_THAT(states.back(), HasSubstr("Does the access list of the broker permit reading it?"));
}

TEST_F(MqttSourceTest, OutlivesTheBroker)
{
    listen();
    send("roof/orientation", kOrientation);
    ASSERT_TRUE(received(1));
    broker->kill();
    ASSERT_TRUE(station.failed() && sensor.failed());
    EXPECT_FALSE(source->status().open);
    EXPECT_THAT(states, ElementsAre("open ", HasSubstr("The connection is lost")));
    ASSERT_TRUE(broker->start());
    station.letTimePass(Seconds(1));
    sensor.letTimePass(Seconds(1));
    ASSERT_TRUE(station.connected() && sensor.connected());
    EXPECT_EQ(states.back(), "open ");
    send("roof/orientation", kOrientation);
    EXPECT_TRUE(received(2));
}

// The connection stays open, because others use it too.
TEST_F(MqttSourceTest, ClosedItHearsNothing)
{
    listen();
    source->close();
    EXPECT_FALSE(source->status().open);
    send("roof/orientation", kOrientation);
    station.client.subscribe(QStringLiteral("mark"));
    ASSERT_TRUE(fakes::waitUntil([this] {
        sensor.client.publish({.topic = QStringLiteral("mark")});
        return !station.messages.empty();
    }));
    EXPECT_TRUE(values.empty());
    EXPECT_TRUE(station.client.isConnected());
    source->open();
    EXPECT_TRUE(source->status().open) << "at once: the connection is there";
}

}  // namespace
}  // namespace boresight::orientation
