// SPDX-License-Identifier: GPL-3.0-or-later
// With the real mosquitto.
#include "core/outputs/broker_output.h"

#include "tests/core/mqtt/mqtt_rig.h"
#include "tests/fakes/mqtt_test.h"

#include <gmock/gmock.h>

#include <memory>
#include <string>
#include <vector>

namespace boresight::outputs {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const QString kTopic = QStringLiteral("shack/transmit");

class BrokerOutputTest : public fakes::MqttTest
{
protected:
    void prepare() override
    {
        ASSERT_TRUE(startBroker());
        listen(reader);
    }
    void listen(mqtt::Rig& rig) const
    {
        rig.client.subscribe(kTopic);
        rig.client.open(mqtt::onLoopback(broker->port()));
        ASSERT_TRUE(rig.connected());
    }
    void begin()
    {
        output = std::make_unique<BrokerOutput>(mqtt::onLoopback(broker->port()), kTopic, clock);
        QObject::connect(output.get(), &Output::reached, output.get(),
                         [this](bool on) { told.emplace_back(on ? "on" : "off"); });
        QObject::connect(output.get(), &Output::failed, output.get(),
                         [this](const QString& reason) { told.push_back(reason.toStdString()); });
    }
    [[nodiscard]] bool tells(std::size_t count) const
    {
        return fakes::waitUntil([this, count] { return told.size() >= count; });
    }
    [[nodiscard]] static std::vector<QByteArray> payloads(const mqtt::Rig& rig)
    {
        std::vector<QByteArray> all;
        std::ranges::transform(rig.messages, std::back_inserter(all), &mqtt::Message::payload);
        return all;
    }

    fakes::ManualClock clock;
    mqtt::Rig reader;
    std::unique_ptr<BrokerOutput> output;
    std::vector<std::string> told;
};

// REQ-TRANSMIT-18: The topic receives "on" or "off". "off" is retained, "on" never is. A later subscriber receives
// "off".
TEST_F(BrokerOutputTest, OnIsNeverRetained)
{
    begin();
    ASSERT_TRUE(tells(1)) << "what it is, as soon as it is connected";
    output->set(true);
    output->set(true);
    ASSERT_TRUE(reader.received(3));
    EXPECT_THAT(payloads(reader), ElementsAre("off", "on", "on"));
    EXPECT_THAT(told, ElementsAre("off", "on", "on"));
    mqtt::Rig late;
    listen(late);
    ASSERT_TRUE(late.received(1));
    EXPECT_THAT(payloads(late), ElementsAre("off"));
    output->set(false);
    output.reset();
    ASSERT_TRUE(reader.received(4));
    EXPECT_EQ(reader.messages.back().payload, "off");
}

// REQ-TRANSMIT-19: The broker sends "off" when the connection breaks. A lost broker is reported, and the wanted state
// is sent again as soon as the broker is back.
TEST_F(BrokerOutputTest, TheWillIsOff)
{
    begin();
    ASSERT_TRUE(tells(1));
    output->set(true);
    ASSERT_TRUE(reader.received(2));
    mqtt::Rig same;  // same client name: the broker disconnects the first one
    const auto oust = [&] {
        mqtt::Broker twin = mqtt::onLoopback(broker->port());
        twin.clientId = QStringLiteral("transmitter");
        same.client.open(twin);
    };
    mqtt::Broker named = mqtt::onLoopback(broker->port());
    named.clientId = QStringLiteral("transmitter");
    output.reset();
    reader.messages.clear();
    output = std::make_unique<BrokerOutput>(named, kTopic, clock);
    output->set(true);
    ASSERT_TRUE(reader.received(1));
    EXPECT_EQ(reader.messages.back().payload, "on");
    oust();
    ASSERT_TRUE(reader.received(2));
    EXPECT_EQ(reader.messages[1].payload, "off") << "the will";
}

// REQ-TRANSMIT-19
TEST_F(BrokerOutputTest, ABrokerThatIsGoneIsATrouble)
{
    begin();
    ASSERT_TRUE(tells(1));
    broker.reset();
    ASSERT_TRUE(tells(2));
    EXPECT_THAT(told.back(), HasSubstr("127.0.0.1"));
    output->set(true);
    EXPECT_EQ(told.size(), 3U);
    EXPECT_EQ(told[2], told[1]);
}

}  // namespace
}  // namespace boresight::outputs
