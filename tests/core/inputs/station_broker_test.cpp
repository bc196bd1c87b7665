// SPDX-License-Identifier: GPL-3.0-or-later
// The station and a real broker.
#include "core/inputs/station_broker.h"

#include "tests/core/station/broker_station.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <gmock/gmock.h>

namespace boresight {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

TEST_F(StationBrokerTest, TellsWhatTheMountDoes)
{
    build(publishing(broker->port()));
    ASSERT_TRUE(connected());
    EXPECT_THAT(heardUntil(kAvailability, "line"), ElementsAre("online"));
    run(200);
    (void)heardUntil(kState, R"("state":"STANDBY")");
    station->request({.id = 1, .request = request::PointSky{{.azimuth = 90_deg, .elevation = 30_deg}}});
    run(100);
    const QJsonObject slewing = QJsonDocument::fromJson(heardUntil(kState, R"("state":"SLEW")").back()).object();
    EXPECT_EQ(slewing[QStringLiteral("target")],
              (QJsonObject{{QStringLiteral("azimuth"), 90.0}, {QStringLiteral("elevation"), 30.0}}));
    EXPECT_EQ(slewing[QStringLiteral("commander")].toString(), QStringLiteral("operator"));
    EXPECT_TRUE(slewing[QStringLiteral("simulated")].toBool());
    EXPECT_TRUE(slewing[QStringLiteral("azimuth")].isDouble());

    station->request({.id = 2, .request = request::Stop{}});
    station->publish();
    (void)heardUntil(kState, R"("stopLatched":true)");
    station->shutDown();
    run(300);
    EXPECT_THAT(heardUntil(kAvailability, "line"), ElementsAre("offline"));
}

// Story: after the drives had lost their power, the last measured position was still published for ever.
// REQ-MQTT-14: The state names the active alarms, and whether every axis has answered within 1 s. An older position is
// `null`.
TEST_F(StationBrokerTest, AnOldPositionIsNone)
{
    build(publishing(broker->port()));
    ASSERT_TRUE(connected());
    run(200);
    const auto isHeard = [this](const char* state, bool withPlace) {
        const auto fits = [&](const mqtt::Message& message) {
            const QJsonObject all = QJsonDocument::fromJson(message.payload).object();
            const QJsonObject axes = all[QStringLiteral("axes")].toObject();
            return all[QStringLiteral("state")].toString() == QLatin1String(state) &&
                   all[QStringLiteral("link")].toObject()[QStringLiteral("up")].toBool() == withPlace &&
                   all[QStringLiteral("alarms")].toArray().isEmpty() == withPlace &&
                   all[QStringLiteral("azimuth")].isDouble() == withPlace &&
                   all[QStringLiteral("elevation")].isDouble() == withPlace &&
                   axes[QStringLiteral("azimuth")].isDouble() == withPlace &&
                   axes[QStringLiteral("elevation")].isDouble() == withPlace;
        };
        return fakes::waitUntil([&] { return std::ranges::any_of(logger.messages, fits); });
    };
    EXPECT_TRUE(isHeard("STANDBY", true));
    link->close();
    run(100);
    EXPECT_TRUE(isHeard("DISCONNECTED", false));
}

// REQ-BRAKE-36: The state that is published has the state of the brake, at once when it changes.
TEST_F(StationBrokerTest, TellsWhetherTheBrakeIsOpen)
{
    profile::Profile profile = publishing(broker->port());
    profile.brake.output = "file:" + stateDir.filePath(QStringLiteral("brake")).toStdString();
    build(profile);
    ASSERT_TRUE(connected());
    run(200);
    (void)heardUntil(kState, R"("brake":{"problem":"","state":"set"})");
    station->request({.id = 1, .request = request::PointSky{{.azimuth = 90_deg, .elevation = 30_deg}}});
    run(100);
    (void)heardUntil(kState, R"("brake":{"problem":"","state":"opens"})");
    run(1);
    (void)heardUntil(kState, R"("brake":{"problem":"","state":"open"})");
}

TEST_F(StationBrokerTest, ALostBrokerIsALineInTheLogAndNothingElse)
{
    build(publishing(broker->port()));
    ASSERT_TRUE(connected());
    EXPECT_FALSE(station->status().broker.retryIn);
    run(500);
    station->request({.id = 1, .request = request::PointSky{{.azimuth = 90_deg, .elevation = 30_deg}}});
    run(50);
    broker->kill();
    ASSERT_TRUE(fakes::waitUntil([this] { return !station->status().broker.connected; }));
    EXPECT_EQ(station->status().broker.retryIn, Seconds(1.0));
    for (int i = 0; i < 30; ++i) {
        run(50);
        QCoreApplication::sendPostedEvents();
    }
    const StationStatus status = station->status();
    EXPECT_EQ(status.state, StationState::Hold) << "it has arrived";
    EXPECT_NEAR(status.azimuth.actual->degrees(), 90.0, 0.3);
    EXPECT_TRUE(status.alarms.empty());
    EXPECT_THAT(status.broker.problem.toStdString(), HasSubstr("MQTT broker 127.0.0.1:"));
    ASSERT_TRUE(fakes::waitUntil([this] {
        clock.advance(Seconds(30));
        return station->status().broker.problem.endsWith(QLatin1Char('?'));
    }));
    EXPECT_THAT(log, Contains(HasSubstr("Is the broker running there? Boresight tries again"))) << "no \"?.\"";
    ASSERT_TRUE(broker->start());
    ASSERT_TRUE(fakes::waitUntil([this] {
        clock.advance(Seconds(30));
        return station->status().broker.connected;
    }));
    run(1);
    EXPECT_THAT(log.front(), HasSubstr("connected to the broker 127.0.0.1:"));
    EXPECT_THAT(log.back(), HasSubstr("connected to the broker 127.0.0.1:"));
    EXPECT_THAT(log[1],
                HasSubstr("The connection is lost (closed by the broker). Boresight tries again at least every 30 s"));
    EXPECT_LE(log.size(), 4U) << "each trouble once";
}

TEST_F(StationBrokerTest, IsSwitchedOnAndOffWithoutAReconnectOfTheMount)
{
    profile::Profile profile = publishing(broker->port());
    profile.mqtt.publish = profile::Publish::Off;
    build(profile);
    run(5);
    EXPECT_FALSE(station->status().broker.wanted);
    EXPECT_EQ(broker->count("New client connected"), 1) << "the logger";

    profile.mqtt.publish = profile::Publish::On;
    station->request({.id = 1, .request = request::ApplyProfile{profile}});
    EXPECT_TRUE(station->status().waitingKeys.empty());
    ASSERT_TRUE(connected());
    EXPECT_THAT(heardUntil(kAvailability, "line"), ElementsAre("online"));
    profile.mqtt.prefix = "boresight/roof";
    station->request({.id = 2, .request = request::ApplyProfile{profile}});
    ASSERT_TRUE(connected());
    EXPECT_THAT(heardUntil(QStringLiteral("boresight/roof/availability"), "line"), ElementsAre("online"));
    profile.mqtt.publish = profile::Publish::Off;
    station->request({.id = 3, .request = request::ApplyProfile{profile}});
    EXPECT_THAT(heardUntil(QStringLiteral("boresight/roof/availability"), "line"), ElementsAre("offline"));
    EXPECT_FALSE(station->status().broker.wanted);
}

// REQ-STATION-48: Broker and power line have their own threads. Every 20 ms the station receives the newest values, at
// most a fixed number of them.
// REQ-MQTT-09e
TEST_F(StationBrokerTest, AMessageThatIsTooLargeIsALineInTheLog)
{
    profile::Profile profile = publishing(broker->port());
    profile.sensor.source = profile::SensorSource::Mqtt;
    build(profile);
    ASSERT_TRUE(connected());
    ASSERT_TRUE(fakes::waitUntil([this] { return broker->count("Sending SUBACK to boresight-") >= 3; }));
    for (int i = 0; i < 3; ++i) {
        logger.client.publish(
            {.topic = toQString(profile.sensor.orientationTopic), .payload = QByteArray(2'048'000, 'x')});
    }
    ASSERT_TRUE(fakes::waitUntil([this] {
        run(1);
        return log.size() > 1;
    }));
    EXPECT_THAT(log[1], HasSubstr("a message of 2000 kB was dropped."));
    run(200);
    (void)heardUntil(kState, R"("state":"STANDBY")");
    EXPECT_EQ(log.size(), 2U) << "one line, and the connection goes on";
}

// If only the sensor uses the broker, nothing is published.
TEST_F(StationBrokerTest, TheSensorGetsTheSameConnection)
{
    EventLog events(clock);
    profile::Profile profile = publishing(broker->port());
    profile.mqtt.publish = profile::Publish::Off;
    profile::InForce inForce(profile);
    StationBroker shared(inForce, events, clock, nullptr);
    shared.open();
    EXPECT_FALSE(shared.status().wanted);
    shared.setSensorWanted(true);
    ASSERT_TRUE(fakes::waitUntil([&] { return shared.status().connected; }));
    EXPECT_FALSE(shared.isPublishing());
    profile.mqtt.publish = profile::Publish::On;
    const auto before = inForce.shared();
    inForce.apply(profile);
    shared.profileChanged(*before, *inForce);
    ASSERT_TRUE(fakes::waitUntil([&] { return shared.isPublishing(); }));
    shared.setSensorWanted(false);
    EXPECT_TRUE(shared.isPublishing()) << "the same connection";
    EXPECT_EQ(broker->count("New client connected"), 3) << "the logger, without a will, with one";
}

// REQ-POSITION-24: By MQTT each message of the topic is one position, and the mount follows it. A retained message is
// old and does not count. An unreadable message is a line in the log. A lost broker is reported.
TEST_F(StationBrokerTest, APositionOfTheTopicIsFollowed)
{
    const QString topic = QStringLiteral("balloon/position");
    logger.client.publish({.topic = topic, .payload = "38.757,-9,30000", .retain = mqtt::Retain::Yes});
    profile::Profile profile = publishing(broker->port());
    profile.mqtt.publish = profile::Publish::Off;
    profile.site = {.known = true, .latitude = 38.757_deg, .longitude = -9.117_deg, .heightMetres = 80.0};
    profile.position.source = profile::PositionSource::Mqtt;
    profile.position.topic = topic.toStdString();
    build(profile);
    ASSERT_TRUE(connected());
    ASSERT_TRUE(fakes::waitUntil([this] { return broker->count("balloon/position (QoS") >= 1; }));
    run(200);
    const auto tell = [&](const QByteArray& payload) { logger.client.publish({.topic = topic, .payload = payload}); };
    tell("38.957,-9.117");
    tell("38.957,-9.117,20000");
    ASSERT_TRUE(fakes::waitUntil([this] { return station->status().position.accepted > 0; }));
    EXPECT_EQ(station->status().position.accepted, 1U) << "the one that was kept does not count";
    EXPECT_EQ(station->status().position.refused, 1U) << "half a line";

    station->request({.id = 1, .request = request::FollowPosition{}});
    run(1000);
    const StationStatus status = station->status();
    EXPECT_EQ(status.position.source, QStringLiteral("MQTT balloon/position"));
    EXPECT_EQ(status.position.phase, PositionPhase::Following);
    EXPECT_NEAR(status.azimuth.actual->wrapped180().degrees(), 0.0, 0.05) << "0.2° north of the mount";
    EXPECT_NEAR(status.elevation.actual->degrees(), 41.75, 0.1);
    broker->kill();
    ASSERT_TRUE(fakes::waitUntil([this] { return !station->status().position.trouble.isEmpty(); }));
}

// REQ-WIND-42: By MQTT a message of the topic is one reading. One that the broker has kept does not count. A broker
// that is gone is reported.
TEST_F(StationBrokerTest, AReadingOfTheTopicIsTheWind)
{
    const QString topic = QStringLiteral("shack/wind");
    logger.client.publish({.topic = topic, .payload = "33", .retain = mqtt::Retain::Yes});
    profile::Profile profile = publishing(broker->port());
    profile.mqtt.publish = profile::Publish::Off;
    profile.wind.source = "mqtt:shack/wind";
    profile.wind.format = {.key = "gust", .unit = wind::Unit::KilometresPerHour};
    build(profile);
    ASSERT_TRUE(connected());
    ASSERT_TRUE(fakes::waitUntil([this] { return broker->count("shack/wind (QoS") >= 1; }));
    run(200);
    EXPECT_EQ(station->status().wind.accepted, 0U);
    logger.client.publish({.topic = topic, .payload = R"({"gust": 36})"});
    ASSERT_TRUE(fakes::waitUntil([this] { return station->status().wind.accepted > 0; }));
    EXPECT_NEAR(station->status().wind.speed.value_or(0.0), 10.0, 1e-9);
    broker->kill();
    ASSERT_TRUE(fakes::waitUntil([this] { return !station->status().wind.trouble.isEmpty(); }));
}

}  // namespace
}  // namespace boresight
