// SPDX-License-Identifier: GPL-3.0-or-later
// The simulated sensor at a real broker. The source for the real sensor receives it.
#include "core/sim_sensor/sensor_publisher.h"

#include "core/orientation_stream/mqtt_source.h"
#include "tests/core/mqtt/mqtt_rig.h"
#include "tests/fakes/mqtt_test.h"

#include <gmock/gmock.h>

namespace boresight::sim {
namespace {

using testing::AllOf;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

class SensorPublisherTest : public fakes::MqttTest
{
protected:
    void prepare() override
    {
        ASSERT_TRUE(startBroker());
        listener.client.subscribe(QStringLiteral("roof/#"));
        connectListener();
    }
    void connectListener()
    {
        listener.client.open(mqtt::onLoopback(broker->port()));
        ASSERT_TRUE(listener.connected());
        ASSERT_TRUE(fakes::waitUntil([this] { return broker->count("Sending SUBACK") > 0; }));
    }
    void begin(PublishedTopics topics = PublishedTopics::All)
    {
        publisher = std::make_unique<SensorPublisher>(box, clock, QStringLiteral("roof/"), topics);
        publisher->client().open(mqtt::onLoopback(broker->port()));
        ASSERT_TRUE(fakes::waitUntil([this] { return publisher->client().isConnected(); }));
    }
    // The topics that are published meanwhile, as the listener receives them.
    std::vector<std::string> heardIn(int seconds)
    {
        listener.messages.clear();
        for (int reading = 0; reading < 5 * seconds; ++reading) {
            clock.advance(SimulatedSensor::kReadingPeriod);
            box.read();
        }
        const QString mark = QStringLiteral("roof/mark");
        publisher->client().publish({.topic = mark});
        EXPECT_TRUE(
            fakes::waitUntil([&] { return !listener.messages.empty() && listener.messages.back().topic == mark; }));
        listener.messages.pop_back();
        std::vector<std::string> topics;
        for (const mqtt::Message& message : listener.messages) {
            topics.push_back(message.topic.toStdString());
        }
        return topics;
    }

    fakes::ManualClock clock;
    SimulatedPair pair{commissionedPair()};
    SensorBox box{pair, clock, clock.now(), {.mountingOffset = 37_deg, .noise = Angle{}}};
    mqtt::Rig listener;
    std::unique_ptr<SensorPublisher> publisher;
};

// REQ-SIM-16 (SensorPublisherTest.*): The sensor publishes at a real broker on the topics, at the rates and in the form
// of its firmware. It reconnects.
TEST_F(SensorPublisherTest, PublishesThreeTopicsAtTheRatesOfTheFirmware)
{
    begin();
    const auto all = heardIn(61);
    EXPECT_NEAR(static_cast<double>(std::ranges::count(all, "roof/orientation")), 60.0, 1.0);
    EXPECT_EQ(std::ranges::count(all, "roof/calibration"), 6);
    EXPECT_EQ(std::ranges::count(all, "roof/status"), 1);
    EXPECT_EQ(all.front(), "roof/calibration") << "known with the first orientation";
    EXPECT_EQ(broker->count("No will message specified"), 2) << "the listener's, and the sensor's";
    EXPECT_EQ(broker->count("d0, q0, r0, m0, 'roof/"), 2 * (std::ssize(all) + 1)) << "in and out, with the mark";
    EXPECT_EQ(broker->count("r1, m0"), 0) << "nothing is retained";
}

TEST_F(SensorPublisherTest, NewerFirmwareTellsOnlyTheOrientation)
{
    begin(PublishedTopics::OrientationOnly);
    EXPECT_THAT(heardIn(30), Each("roof/orientation"));
}

TEST_F(SensorPublisherTest, IsHeardAsTheRealOneIs)
{
    orientation::MqttSource source(listener.client,
                                   {.orientation = QStringLiteral("roof/orientation"),
                                    .status = QStringLiteral("roof/status"),
                                    .calibration = QStringLiteral("roof/calibration")},
                                   listener.clock);
    std::vector<orientation::Orientation> values;
    QObject::connect(&source, &orientation::SensorSource::received, &source,
                     [&](const orientation::Orientation& value) { values.push_back(value); });
    source.open();
    begin();
    (void)heardIn(3);
    ASSERT_GE(values.size(), 2U);
    EXPECT_NEAR(values.back().heading.angle().degrees(), 323.0, 0.01) << "0° less its mounting";
    EXPECT_NEAR(values.back().elevation.degrees(), 10.0, 0.01);
    ASSERT_TRUE(values.back().calibration);
    EXPECT_EQ(values.back().calibration->magnetometer, 3);
    EXPECT_EQ(source.status().counts.allRefused(), 0U);
}

TEST_F(SensorPublisherTest, FailsWhenThePairsFaultsSaySo)
{
    begin(PublishedTopics::OrientationOnly);
    pair.faults().add({.kind = FaultKind::SensorSilence, .at = Seconds(10.0), .duration = Seconds(20.0)});
    pair.faults().add({.kind = FaultKind::SensorDead, .at = Seconds(40.0), .duration = Seconds(20.0)});
    EXPECT_FALSE(heardIn(11).empty());
    EXPECT_THAT(heardIn(18), ElementsAre());
    EXPECT_FALSE(heardIn(10).empty()) << "the power is back";
    (void)heardIn(5);
    EXPECT_FALSE(heardIn(10).empty());
    EXPECT_THAT(listener.messages.back().payload.toStdString(),
                AllOf(HasSubstr("\"azimuth\": 5.07"), HasSubstr("\"elevation\": 0.00")));
    (void)heardIn(8);
    EXPECT_FALSE(heardIn(5).empty());
    EXPECT_THAT(listener.messages.back().payload.toStdString(), Not(HasSubstr("\"elevation\": 0.00")));
}

TEST_F(SensorPublisherTest, FindsABrokerThatIsStartedAgain)
{
    begin(PublishedTopics::OrientationOnly);
    broker->kill();
    ASSERT_TRUE(fakes::waitUntil([this] { return publisher->client().nextAttempt().has_value(); }));
    ASSERT_TRUE(listener.failed());
    ASSERT_TRUE(broker->start());
    listener.letTimePass(Seconds(1.0));
    ASSERT_TRUE(listener.connected());
    clock.advance(Seconds(1.0));
    publisher->client().service();
    ASSERT_TRUE(fakes::waitUntil([this] { return publisher->client().isConnected(); }));
    EXPECT_FALSE(heardIn(3).empty());
}

}  // namespace
}  // namespace boresight::sim
