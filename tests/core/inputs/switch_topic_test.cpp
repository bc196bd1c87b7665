// SPDX-License-Identifier: GPL-3.0-or-later
// End switches at topics of a real broker.
#include "core/inputs/station_switches.h"
#include "tests/core/station/broker_station.h"

namespace boresight {
namespace {

// REQ-ENDSWITCH-64: A switch is read from its topic. A retained message, and a message that is neither on nor off, is
// no reading. A message that is older than end_switches.silence_s does not count.
TEST_F(StationBrokerTest, ReadsAnEndSwitchFromItsTopic)
{
    profile::Profile profile = publishing(broker->port());
    profile.mqtt.publish = profile::Publish::Off;
    profile.endSwitches.inputs[1] = "mqtt:roof/end";
    const profile::InForce inForce(profile);
    EventLog events(clock);
    StationBroker read(inForce, events, clock, nullptr);
    StationSwitches switches(inForce, {}, events, clock, read, nullptr);
    const auto reading = [&switches] { return switches.read().at(1); };
    const auto say = [this](const QByteArray& text, mqtt::Retain retain) {
        logger.client.publish({.topic = QStringLiteral("roof/end"), .payload = text, .retain = retain});
    };
    say("off", mqtt::Retain::Yes);
    read.open();
    switches.open();
    ASSERT_TRUE(fakes::waitUntil([&] { return broker->count("Sending SUBACK to boresight-") >= 1; }));
    EXPECT_FALSE(reading().isOn) << "a retained message";
    say("on", mqtt::Retain::No);
    ASSERT_TRUE(fakes::waitUntil([&] { return reading().isOn == true; }));
    say("loose", mqtt::Retain::No);
    say("off", mqtt::Retain::No);
    ASSERT_TRUE(fakes::waitUntil([&] { return reading().isOn == false; }));
    clock.advance(Seconds(4.9));
    EXPECT_EQ(reading().isOn, false);
    clock.advance(Seconds(0.2));
    EXPECT_EQ(reading(), (contacts::InputReading{.problem = QStringLiteral("no message for 5 s")}));
    switches.close();
    read.close();
}

}  // namespace
}  // namespace boresight
