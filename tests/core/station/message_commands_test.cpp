// SPDX-License-Identifier: GPL-3.0-or-later
// Commands for the mount by a real broker, and the messages for Home Assistant.
#include "core/station/message_commands.h"

#include "tests/core/station/broker_station.h"

#include <QJsonDocument>
#include <QJsonObject>

#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <utility>

namespace boresight {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

profile::Profile commanded(std::uint16_t port, profile::BrokerCommands commands = profile::BrokerCommands::Drive)
{
    profile::Profile profile = publishing(port);
    profile.mqtt.publish = profile::Publish::Off;
    profile.mqtt.commands = commands;
    return profile;
}

class MessageCommandsTest : public StationBrokerTest
{
protected:
    // Runs until the broker has granted both topics, and then for 4 s of station time.
    void begin(const profile::Profile& profile)
    {
        build(profile);
        ASSERT_TRUE(connected());
        ASSERT_TRUE(isSubscribed(1));
        run(200);
    }
    [[nodiscard]] bool isSubscribed(qsizetype times) const
    {
        return fakes::waitUntil([&] {
            return broker->count("boresight/command (QoS 0)") >= times &&
                   broker->count("boresight/stop (QoS 0)") >= times;
        });
    }
    void send(const char* topic, const QByteArray& message, mqtt::Retain retain = mqtt::Retain::No)
    {
        ASSERT_TRUE(logger.client.publish({.topic = QLatin1String(topic), .payload = message, .retain = retain}));
    }
    // The answer to this command.
    std::string ask(const QByteArray& command)
    {
        send("boresight/command", command);
        const QByteArray answer = heardUntil(kAnswer, "\"command\":\"" + command + "\"").back();
        return QJsonDocument::fromJson(answer).object()[QStringLiteral("answer")].toString().toStdString();
    }
    [[nodiscard]] std::vector<ClientStatus> clients() const { return station->status().clients; }
    void apply(const profile::Profile& profile)
    {
        station->request({.id = ++m_request, .request = request::ApplyProfile{profile}});
    }

    const QString kAnswer = QStringLiteral("boresight/answer");

private:
    std::uint64_t m_request = 0;
};

// REQ-MQTTCOMMANDS-10: If commands are permitted, Boresight reads `PREFIXcommand` and `PREFIXstop` and answers on
// `PREFIXanswer`. The senders are in the list of clients. Retained messages are refused with an answer at every
// connection.
// REQ-MQTTCOMMANDS-03
TEST_F(MessageCommandsTest, ACommandMovesTheMount)
{
    send("boresight/command", "200 60", mqtt::Retain::Yes);
    send("boresight/stop", "stop", mqtt::Retain::Yes);
    ASSERT_TRUE(logger.received(2));
    begin(commanded(broker->port()));
    const auto refused = heardUntil(kAnswer, R"("command":"200 60")");
    EXPECT_THAT(refused.back().toStdString(), HasSubstr("The broker kept this message, so it is old."));
    EXPECT_FALSE(station->status().stopLatched);
    EXPECT_EQ(station->status().state, StationState::Standby);

    EXPECT_EQ(ask("40 30"), "OK");
    run(1000);
    EXPECT_NEAR(station->status().azimuth.actual->degrees(), 40.0, 0.3);
    ASSERT_THAT(clients(), SizeIs(1));
    EXPECT_EQ(clients().front().program, QStringLiteral("MQTT"));
    EXPECT_EQ(clients().front().address, QStringLiteral("topic boresight/command"));
    EXPECT_EQ(clients().front().lastCommand, QStringLiteral("40 30"));
    EXPECT_THAT(ask("?"), HasSubstr("30.0"));
    EXPECT_THAT(ask("open the door"), HasSubstr("error: \"open the door\" is not a command."));
}

// REQ-MQTTCOMMANDS-04
TEST_F(MessageCommandsTest, ACommandAfterAPauseOfTheProgramMovesNothing)
{
    begin(commanded(broker->port()));
    clock.advance(Seconds(3.0));  // without a tick
    EXPECT_THAT(ask("40 30"), HasSubstr("This command may be old. Send it again."));
    EXPECT_EQ(station->status().state, StationState::Standby);
}

// REQ-MQTTCOMMANDS-14
TEST_F(MessageCommandsTest, AQuestionDoesNotKeepControl)
{
    begin(commanded(broker->port()));
    ASSERT_EQ(ask("40 30"), "OK");
    EXPECT_TRUE(clients().front().inControl);
    for (int i = 0; i < 5; ++i) {
        run(110);
        EXPECT_THAT(ask("?"), HasSubstr("."));
    }
    EXPECT_FALSE(clients().front().inControl) << "11 s after the motion";
}

// REQ-MQTTCOMMANDS-06
TEST_F(MessageCommandsTest, AMessageOfTheTopicStopLatchesStop)
{
    begin(commanded(broker->port(), profile::BrokerCommands::Stop));
    station->request({.id = 50, .request = request::PointSky{{.azimuth = 200_deg, .elevation = 30_deg}}});
    run(50);
    EXPECT_THAT(ask("40 30"), HasSubstr("only stopping and reading by MQTT"));
    EXPECT_EQ(station->status().state, StationState::Slew);
    send("boresight/stop", "PRESS");
    ASSERT_TRUE(fakes::waitUntil([this] { return station->status().stopLatched; })) << "without a tick of the timer";
    run(200);
    EXPECT_EQ(station->status().state, StationState::Stopped);
}

// Story: each message of a flood caused a tick, and each tick sends frames to the drives.
// REQ-MQTTCOMMANDS-07
TEST_F(MessageCommandsTest, AFloodOfStopIsNoFloodOfTicks)
{
    begin(commanded(broker->port()));
    int ticks = 0;
    QObject::connect(station.get(), &Station::ticked, station.get(), [&ticks] { ++ticks; });
    for (int i = 0; i < 500; ++i) {
        send("boresight/stop", "stop");
    }
    ASSERT_TRUE(fakes::waitUntil([this] {
        clock.advance(Seconds(1.0));
        send("boresight/command", "the last one");
        return std::ranges::any_of(logger.messages,
                                   [](const mqtt::Message& one) { return one.payload.contains("is not a command"); });
    }));
    EXPECT_EQ(ticks, 1);
    EXPECT_TRUE(station->status().stopLatched);
}

// REQ-MQTTCOMMANDS-11: By default commands are off, and Boresight does not read their topics. A change of this setting
// applies at once.
TEST_F(MessageCommandsTest, AreOffUntilTheProfilePermitsThem)
{
    profile::Profile profile = publishing(broker->port());
    EXPECT_EQ(profile.mqtt.commands, profile::BrokerCommands::Off);
    build(profile);
    ASSERT_TRUE(connected());
    run(200);
    send("boresight/stop", "stop");
    send("boresight/command", "stop");
    (void)heardUntil(kState, R"("state":"STANDBY")");
    EXPECT_FALSE(station->status().stopLatched);
    EXPECT_EQ(broker->count("boresight/command (QoS 0)"), 0);
    EXPECT_THAT(clients(), IsEmpty());

    profile.mqtt.commands = profile::BrokerCommands::Drive;
    apply(profile);
    ASSERT_TRUE(isSubscribed(1));
    run(200);
    EXPECT_EQ(ask("40 30"), "OK");
    profile.mqtt.commands = profile::BrokerCommands::Stop;
    apply(profile);
    ASSERT_TRUE(isSubscribed(2));
    run(200);
    EXPECT_THAT(ask("50 30"), HasSubstr("only stopping and reading by MQTT"));
    EXPECT_EQ(ask("hold"), "OK");
    profile.mqtt.commands = profile::BrokerCommands::Off;
    apply(profile);
    EXPECT_THAT(clients(), IsEmpty());
}

// The mount continues to its last target and stays there.
// REQ-MQTTCOMMANDS-09
TEST_F(MessageCommandsTest, ALostBrokerIsALostClient)
{
    begin(commanded(broker->port()));
    ASSERT_EQ(ask("40 30"), "OK");
    const std::uint64_t first = clients().front().id;
    broker->kill();
    ASSERT_TRUE(fakes::waitUntil([this] {
        run(1);
        return clients().empty();
    }));
    run(1000);
    EXPECT_NEAR(station->status().azimuth.actual->degrees(), 40.0, 0.3);
    EXPECT_EQ(station->status().state, StationState::Hold);
    ASSERT_TRUE(broker->start());
    ASSERT_TRUE(fakes::waitUntil([this] {
        clock.advance(Seconds(1));
        return station->status().broker.connected;
    }));
    ASSERT_THAT(clients(), SizeIs(1));
    EXPECT_GT(clients().front().id, first);
    station->request({.id = 60, .request = request::Disconnect{clients().front().id}});
    ASSERT_THAT(clients(), SizeIs(1));
    EXPECT_GT(clients().front().id, first + 1) << "it begins anew";
}

// REQ-MQTTCOMMANDS-13: An alarm reports that everybody who can reach a broker on another computer can move the mount.
TEST_F(MessageCommandsTest, ABrokerThatIsOpenToAllIsAnAlarm)
{
    profile::Profile profile = commanded(broker->port());
    build(profile);
    const auto isRaised = [this] {
        const std::vector<Alarm> alarms = station->status().alarms;
        return std::ranges::any_of(
            alarms, [](const Alarm& one) { return one.active && one.name == QStringLiteral("mqtt.open"); });
    };
    EXPECT_FALSE(isRaised()) << "on this computer";
    profile.mqtt.host = "192.0.2.1";
    apply(profile);
    EXPECT_TRUE(isRaised());
    profile.mqtt.user = "mount";
    apply(profile);
    EXPECT_FALSE(isRaised());
    profile.mqtt.user.clear();
    profile.mqtt.commands = profile::BrokerCommands::Stop;
    apply(profile);
    EXPECT_FALSE(isRaised()) << "they stop it at most";
}

// If the access list of the broker refuses a topic, the log names the topic.
TEST_F(MessageCommandsTest, ATopicThatTheBrokerRefusesIsALineInTheLog)
{
    if (!fakes::MqttBroker::canBeGuarded()) {
        GTEST_SKIP() << "no dynamic-security plugin of mosquitto";
    }
    ASSERT_TRUE(startBroker(Door::Guarded));
    build(commanded(broker->port()));
    ASSERT_TRUE(fakes::waitUntil([this] {
        run(1);
        return std::ranges::any_of(log,
                                   [](const std::string& line) { return line.find("boresight/stop") != line.npos; });
    }));
    EXPECT_THAT(log, Contains(HasSubstr("does not let Boresight read the topic boresight/command. No command")));
}

// What a client receives of the messages for Home Assistant. It is connected all the time.
struct HomeRig : mqtt::Rig
{
    explicit HomeRig(std::uint16_t port)
    {
        client.subscribe(QStringLiteral("homeassistant/#"));
        client.open(mqtt::onLoopback(port));
    }
    // The number of entities that exist now.
    [[nodiscard]] std::size_t entities() const
    {
        std::map<QString, bool> present;
        for (const mqtt::Message& message : messages) {
            present[message.topic] = !message.payload.isEmpty();
        }
        return static_cast<std::size_t>(std::ranges::count(present, true, &std::pair<const QString, bool>::second));
    }
    [[nodiscard]] std::size_t removed() const
    {
        return static_cast<std::size_t>(
            std::ranges::count_if(messages, [](const mqtt::Message& one) { return one.payload.isEmpty(); }));
    }
};

profile::Profile described(std::uint16_t port)
{
    profile::Profile profile = publishing(port);
    profile.mqtt.homeAssistant = profile::HomeAssistant::On;
    return profile;
}

// Story: the entities stayed at the old broker for ever, because their topics are the same at the new one.
// REQ-MQTT-13
TEST_F(MessageCommandsTest, HomeAssistantForgetsAMountThatGoesToAnotherBroker)
{
    HomeRig old(broker->port());
    fakes::MqttBroker other;
    ASSERT_TRUE(old.connected());
    ASSERT_TRUE(other.start());
    HomeRig next(other.port());
    ASSERT_TRUE(next.connected());
    build(described(broker->port()));
    ASSERT_TRUE(fakes::waitUntil([&] { return old.entities() == 9; }));
    apply(described(other.port()));
    EXPECT_TRUE(fakes::waitUntil([&] { return old.entities() == 0; }));
    EXPECT_TRUE(fakes::waitUntil([&] { return next.entities() == 9; }));
    profile::Profile off = described(other.port());
    off.mqtt.homeAssistant = profile::HomeAssistant::Off;
    off.mqtt.publish = profile::Publish::Off;
    apply(off);
    EXPECT_TRUE(fakes::waitUntil([&] { return next.entities() == 0; })) << "before the connection ends";
}

// REQ-MQTT-13
TEST_F(MessageCommandsTest, HomeAssistantForgetsWhenTheBrokerIsBack)
{
    fakes::MqttBroker away;
    profile::Profile profile = described(away.port());
    build(profile);
    profile.mqtt.prefix = "roof/";
    apply(profile);
    // The next attempt needs the clock, so `home` reads before the station connects.
    ASSERT_TRUE(fakes::waitUntil([this] { return !station->status().broker.problem.isEmpty(); }));
    ASSERT_TRUE(away.start());
    HomeRig home(away.port());
    ASSERT_TRUE(fakes::waitUntil([&] { return away.count("homeassistant/# (QoS 0)") == 1; }));
    ASSERT_TRUE(fakes::waitUntil([this] {
        run(50);
        return station->status().broker.connected;
    }));
    EXPECT_TRUE(fakes::waitUntil([&] { return home.entities() == 9 && home.removed() == 12; }))
        << "those of the old prefix are removed, and three that are not offered";
}

// REQ-MQTT-11
// REQ-MQTT-12
// REQ-MQTT-13
TEST_F(MessageCommandsTest, HomeAssistantFindsTheMount)
{
    // The messages that a client receives that connects later.
    const auto found = [this] {
        mqtt::Rig finder;
        finder.client.subscribe(QStringLiteral("homeassistant/#"));
        finder.client.subscribe(QStringLiteral("boresight/mark"));
        finder.client.open(mqtt::onLoopback(broker->port()));
        EXPECT_TRUE(finder.connected());
        EXPECT_TRUE(fakes::waitUntil([&] {
            finder.client.publish({.topic = QStringLiteral("boresight/mark")});
            return !finder.messages.empty() && finder.messages.back().topic == QStringLiteral("boresight/mark");
        }));
        std::vector<std::string> topics;
        for (const mqtt::Message& message : finder.messages) {
            if (message.topic != QStringLiteral("boresight/mark")) {
                topics.push_back(message.topic.section(QLatin1Char('/'), 1, 2).toStdString());
            }
        }
        return topics;
    };
    profile::Profile profile = publishing(broker->port());
    profile.mqtt.homeAssistant = profile::HomeAssistant::On;
    profile.mqtt.commands = profile::BrokerCommands::Drive;
    begin(profile);
    (void)heardUntil(kState, R"("link":{"problem":"","up":true})");
    EXPECT_THAT(found(), SizeIs(12));
    EXPECT_THAT(found(), Contains("button/boresight_park"));

    profile.mqtt.commands = profile::BrokerCommands::Stop;
    apply(profile);
    (void)heardUntil(kAvailability, "online");
    EXPECT_THAT(found(), SizeIs(11));
    EXPECT_THAT(found(), Not(Contains("button/boresight_park")));
    profile.mqtt.homeAssistant = profile::HomeAssistant::Off;
    apply(profile);
    (void)heardUntil(kAvailability, "online");
    EXPECT_THAT(found(), IsEmpty());
}

}  // namespace
}  // namespace boresight
