// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mqtt/state_publisher.h"

#include "tests/core/mqtt/mqtt_rig.h"
#include "tests/fakes/mqtt_test.h"

#include <gmock/gmock.h>

namespace boresight::mqtt {
namespace {

using testing::ElementsAre;

const QString kPrefix = QStringLiteral("shack/mount");
const QString kAvailability = QStringLiteral("shack/mount/availability");

class MqttStatePublisher : public fakes::MqttTest
{
protected:
    void prepare() override
    {
        ASSERT_TRUE(startBroker());
        logger.client.subscribe(kPrefix + QStringLiteral("/#"));
        logger.client.open(onLoopback(broker->port()));
        ASSERT_TRUE(logger.connected());
        station = std::make_unique<Rig>();
        publisher = std::make_unique<StatePublisher>(station->client, station->clock, kPrefix);
        station->client.open(onLoopback(broker->port()), StatePublisher::will(kPrefix));
        ASSERT_TRUE(station->connected());
    }
    // Everything that the station has published so far.
    std::vector<Message> published()
    {
        EXPECT_TRUE(station->client.publish({.topic = kPrefix + QStringLiteral("/mark")}));
        const auto isMark = [](const Message& message) { return message.topic.endsWith(QLatin1String("mark")); };
        EXPECT_TRUE(fakes::waitUntil([&] { return !logger.messages.empty() && isMark(logger.messages.back()); }));
        std::vector<Message> all = std::exchange(logger.messages, {});
        all.pop_back();
        return all;
    }
    // The next message that is published.
    Message next()
    {
        EXPECT_TRUE(logger.received(1));
        const Message first = logger.messages.empty() ? Message() : logger.messages.front();
        logger.messages.clear();
        return first;
    }
    static PublishedState in(const char* state)
    {
        PublishedState result;
        result.state = QLatin1String(state);
        return result;
    }
    static Message telling(const PublishedState& state)
    {
        return {.topic = kPrefix + QStringLiteral("/state"), .payload = toJson(state)};
    }

    Rig logger;
    std::unique_ptr<Rig> station;
    std::unique_ptr<StatePublisher> publisher;
};

// REQ-MQTT-08 (MqttStatePublisher.*): The state is published each second, at every change, and at once after a
// reconnect.
TEST_F(MqttStatePublisher, TellsEachSecondAndAtEveryChangeOfState)
{
    publisher->show(in("HOLD"));
    publisher->show(in("HOLD"));
    EXPECT_THAT(published(), ElementsAre(Message{.topic = kAvailability, .payload = "online"}, telling(in("HOLD"))));
    station->clock.advance(Seconds(0.9));
    publisher->show(in("HOLD"));
    EXPECT_THAT(published(), ElementsAre());
    publisher->show(in("SLEW"));
    EXPECT_THAT(published(), ElementsAre(telling(in("SLEW"))));
    station->clock.advance(Seconds(0.9));
    publisher->show(in("SLEW"));
    EXPECT_THAT(published(), ElementsAre()) << "a second from the last time";
    station->clock.advance(Seconds(0.2));
    publisher->show(in("SLEW"));
    EXPECT_THAT(published(), ElementsAre(telling(in("SLEW"))));
    PublishedState stopped = in("SLEW");
    stopped.stopLatched = true;
    publisher->show(stopped);
    EXPECT_THAT(published(), ElementsAre(telling(stopped)));
    PublishedState alarmed = stopped;
    alarmed.alarms = {{.id = QStringLiteral("drive.silent"),
                       .about = QStringLiteral("azimuth"),
                       .severity = QStringLiteral("alarm"),
                       .text = QStringLiteral("silent for 1 s")}};
    publisher->show(alarmed);
    EXPECT_THAT(published(), ElementsAre(telling(alarmed)));
    alarmed.alarms.front().text = QStringLiteral("silent for 2 s");
    publisher->show(alarmed);
    EXPECT_THAT(published(), ElementsAre()) << "seconds are no news";
    alarmed.isLinked = true;
    publisher->show(alarmed);
    EXPECT_THAT(published(), ElementsAre(telling(alarmed)));
}

// REQ-HOOKS-15: A moment of the schedule is published when it comes, and is not retained.
TEST_F(MqttStatePublisher, TellsTheMomentsOfTheSchedule)
{
    (void)published();
    publisher->tell(R"({"event":"aos"})");
    EXPECT_THAT(published(),
                ElementsAre(Message{.topic = kPrefix + QStringLiteral("/schedule"), .payload = R"({"event":"aos"})"}));
}

// REQ-MQTT-07
TEST_F(MqttStatePublisher, SaysOfflineWhenItEndsAndTheBrokerSaysItWhenItDies)
{
    const Message online{.topic = kAvailability, .payload = "online"};
    const Message offline{.topic = kAvailability, .payload = "offline"};
    EXPECT_EQ(next(), online);
    publisher->sayOffline();
    station->client.close();
    EXPECT_EQ(next(), offline);
    station->client.open(onLoopback(broker->port()), StatePublisher::will(kPrefix));
    EXPECT_EQ(next(), online);
    publisher.reset();
    station.reset();
    EXPECT_EQ(next(), offline);
}

// Nobody received the last message, so the next one does not wait for its second.
TEST_F(MqttStatePublisher, TellsAtOnceWhenTheBrokerIsBack)
{
    publisher->show(in("HOLD"));
    broker->kill();
    ASSERT_TRUE(station->failed() && logger.failed());
    publisher->show(in("TRACK"));
    ASSERT_TRUE(broker->start());
    logger.letTimePass(Seconds(1));
    ASSERT_TRUE(logger.connected());
    logger.messages.clear();
    station->letTimePass(Seconds(1));
    ASSERT_TRUE(station->connected());
    publisher->show(in("TRACK"));
    EXPECT_THAT(published(), ElementsAre(Message{.topic = kAvailability, .payload = "online"}, telling(in("TRACK"))));
}

}  // namespace
}  // namespace boresight::mqtt
