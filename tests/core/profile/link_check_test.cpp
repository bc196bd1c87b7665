// SPDX-License-Identifier: GPL-3.0-or-later
// Checks of the settings for links to other programs and devices: ports, topics and outputs that belong together.
#include "tests/core/profile/problem_keys.h"

#include <gtest/gtest.h>

using namespace boresight;
using namespace boresight::profile;

// REQ-PROFILE-963: A setting of Hamlib is NAME=VALUE, without blanks and commas, and each name is there once. The port
// and its speed have keys of their own and are refused here, with the reason. A limit must be a number, because rotctld
// uses 0 for a word. Numbers in place of names are refused, too. All settings together have at most 1000 bytes, with a
// comma between two, because rotctld accepts no more.
TEST(CrossCheck, ASettingOfHamlibHasANameAndAValue)
{
    Profile profile;
    const Setting& setting = *findSetting("bus.hamlib_settings");
    for (const char* const bad :
         {"", "min_az", "min_az=", "=5", "min az=5", "MIN_AZ=5", "stop_bits=2,retry=1", "stop_bits=2 ", "a=b=c",
          "timeout=1\n", "-C=1", "min_az=abc", "max_el=9O", "1073741834=/tmp/xyz", "_az=5"}) {
        EXPECT_FALSE(setting.set(profile, TextList{bad})) << bad;
    }
    EXPECT_FALSE(setting.set(profile, TextList{"timeout=" + std::string(100, '1')}));
    for (const auto& [own, key] :
         {std::pair{"rot_pathname=/dev/ttyS0", "bus.name"}, {"serial_speed=600", "bus.baud"}}) {
        const Result<> set = setting.set(profile, TextList{own});
        ASSERT_FALSE(set) << own;
        EXPECT_TRUE(set.error().text.contains(QLatin1String(key))) << set.error().text.toStdString();
    }
    ASSERT_TRUE(setting.set(profile, TextList{"min_az=-90", "write_delay=5", "stop_bits=2", "serial_parity=None"}));
    EXPECT_TRUE(crossCheck(profile).empty());
    ASSERT_TRUE(setting.set(profile, TextList{"min_az=-90", "stop_bits=2", "min_az=0"}));
    EXPECT_EQ(keysOf(crossCheck(profile)), std::vector<std::string>{"bus.hamlib_settings"});
}

// Story: rotctld ended at once, and no alarm gave the reason.
// REQ-PROFILE-963
TEST(CrossCheck, TheSettingsOfHamlibTogetherFitIntoRotctld)
{
    Profile profile;
    const Setting& setting = *findSetting("bus.hamlib_settings");
    TextList list;
    for (int i = 0; i < 10; ++i) {
        list.push_back("name_" + std::to_string(i) + "=" + std::string(93, '1'));
    }
    list.back().resize(list.back().size() - 9);  // 9 commas
    ASSERT_TRUE(setting.set(profile, list));
    EXPECT_TRUE(crossCheck(profile).empty()) << "1000 bytes";
    list.back() += '1';
    ASSERT_TRUE(setting.set(profile, list));
    ASSERT_EQ(keysOf(crossCheck(profile)), std::vector<std::string>{"bus.hamlib_settings"});
    EXPECT_TRUE(crossCheck(profile).front().text.contains(QStringLiteral("has 1001 bytes")));
}

// REQ-PROFILE-06
TEST(CrossCheck, ALockedMountSaysToWhom)
{
    Profile profile;
    profile.rotctld.control = ControlRule::Locked;
    EXPECT_EQ(keysOf(crossCheck(profile)), std::vector<std::string>{"rotctld.locked_to"});
    profile.rotctld.lockedTo = "::1";
    EXPECT_TRUE(crossCheck(profile).empty());
}

TEST(CrossCheck, APasswordNeedsAUser)
{
    Profile profile;
    profile.mqtt.password = "s3cret";
    EXPECT_EQ(keysOf(crossCheck(profile)), std::vector<std::string>{"mqtt.user"});
    profile.mqtt.user = "mount";
    EXPECT_TRUE(crossCheck(profile).empty());
}

// REQ-LISTENERS-13: A listener has a port or a path of its own, also beside the ports of rotctld, positions, power and
// wind.
TEST(CrossCheck, AListenerHasAPlaceOfItsOwn)
{
    Profile profile;
    profile.listeners = {"gs232b drive tcp:127.0.0.1:4534", "pst drive udp:127.0.0.1:4534",
                         "pst read udp:127.0.0.1:4535"};
    EXPECT_TRUE(crossCheck(profile).empty());
    profile.listeners.emplace_back("n1mm read udp:127.0.0.1:4535");
    EXPECT_EQ(keysOf(crossCheck(profile)), std::vector<std::string>{"listeners.list"});
    for (const char* const taken : {"gs232b drive tcp:127.0.0.1:4533", "pst drive udp:127.0.0.1:4540",
                                    "pst read udp:0.0.0.0:4541", "n1mm drive udp:127.0.0.1:55673"}) {
        Profile other;
        other.listeners = {taken};
        other.power.source = PowerSource::Udp;
        other.position.source = PositionSource::Udp;
        other.wind.source = "udp:4541";
        EXPECT_EQ(keysOf(crossCheck(other)), std::vector<std::string>{"listeners.list"}) << taken;
    }
}

// REQ-MQTTCOMMANDS-12: Home Assistant needs the published state. The topics of commands have no other reader.
TEST(CrossCheck, TheTopicsOfCommandsAreTheirOwn)
{
    Profile profile;
    profile.mqtt.homeAssistant = HomeAssistant::On;
    EXPECT_EQ(keysOf(crossCheck(profile)), std::vector<std::string>{"mqtt.home_assistant"});
    profile.mqtt.publish = Publish::On;
    profile.wind.source = "mqtt:boresight/stop";
    profile.position.source = PositionSource::Mqtt;
    profile.position.topic = "boresight/command";
    EXPECT_TRUE(crossCheck(profile).empty()) << "they are off";
    profile.mqtt.commands = BrokerCommands::Stop;
    EXPECT_EQ(keysOf(crossCheck(profile)), (std::vector<std::string>{"mqtt.prefix", "mqtt.prefix"}));
    profile.mqtt.prefix = "boresight";
    EXPECT_EQ(keysOf(crossCheck(profile)), (std::vector<std::string>{"mqtt.prefix", "mqtt.prefix"})) << "no slash";
    profile.mqtt.prefix = "roof";
    EXPECT_TRUE(crossCheck(profile).empty());
    EXPECT_EQ(profile.mqtt.topic("stop"), "roof/stop");
}

// The "on" of the output, sent each second, would latch STOP.
// REQ-TRANSMIT-33: An output is no topic that Boresight itself reads or publishes.
TEST(CrossCheck, ATransmitOutputIsNoTopicOfBoresight)
{
    Profile profile;
    const auto isRefused = [&profile](const std::string& output) {
        profile.transmit.output = output;
        return keysOf(crossCheck(profile)) == std::vector<std::string>{"transmit.output"};
    };
    profile.transmit.output = "mqtt:boresight/stop";
    EXPECT_TRUE(crossCheck(profile).empty()) << "commands are off";
    profile.mqtt.commands = BrokerCommands::Stop;
    ASSERT_TRUE(isRefused("mqtt:boresight/stop"));
    EXPECT_EQ(crossCheck(profile).front().text.toStdString(),
              "Boresight takes each message of the topic boresight/stop for a command (mqtt.commands). Choose another "
              "topic");
    EXPECT_TRUE(isRefused("mqtt:boresight/command"));
    EXPECT_TRUE(isRefused("mqtt:boresight/answer"));
    EXPECT_FALSE(isRefused("mqtt:boresight/state")) << "nothing is published";
    profile.mqtt.publish = Publish::On;
    EXPECT_TRUE(isRefused("mqtt:boresight/state"));
    EXPECT_TRUE(isRefused("mqtt:boresight/availability"));
    profile.wind.source = "mqtt:roof/wind";
    EXPECT_TRUE(isRefused("mqtt:roof/wind"));
    EXPECT_FALSE(isRefused("mqtt:roof/stop"));
    EXPECT_FALSE(isRefused("file:/boresight/stop"));
    profile.mqtt.prefix = "roof";
    EXPECT_TRUE(isRefused("mqtt:roof/stop")) << "a prefix without a slash";
}

// REQ-BRAKE-10: The brake output is neither the transmit output nor a topic that Boresight itself reads or publishes.
TEST(CrossCheck, TheBrakeHasAnOutputOfItsOwn)
{
    Profile profile;
    profile.transmit.output = "rts:/dev/ttyUSB0";
    profile.brake.output = "rts:/dev/ttyUSB0";
    EXPECT_EQ(keysOf(crossCheck(profile)), std::vector<std::string>{"brake.output"});
    profile.brake.output = "dtr:/dev/ttyUSB0";
    EXPECT_EQ(keysOf(crossCheck(profile)), std::vector<std::string>{"brake.output"}) << "one program has the port";
    profile.brake.output = "dtr:/dev/ttyUSB1";
    EXPECT_TRUE(crossCheck(profile).empty());
    profile.mqtt.commands = BrokerCommands::Stop;
    profile.brake.output = "mqtt:boresight/stop";
    EXPECT_EQ(keysOf(crossCheck(profile)), std::vector<std::string>{"brake.output"});
}

// REQ-ENDSWITCH-05: Each end switch has an input of its own. It is no topic that Boresight itself takes commands from
// or publishes, no port of an output, and no pin of a moteus on a mount without one.
TEST(CrossCheck, AnEndSwitchHasAnInputOfItsOwn)
{
    const std::vector<std::string> upper{"end_switches.azimuth_upper"};
    Profile profile;
    const auto keysWith = [&profile](const std::string& input) {
        profile.endSwitches.inputs[1] = input;
        return keysOf(crossCheck(profile));
    };
    EXPECT_TRUE(keysWith("mqtt:roof/end").empty());
    EXPECT_TRUE(keysWith("moteus:1:aux1.0").empty());
    EXPECT_TRUE(keysWith("cts:/dev/ttyUSB0").empty());
    profile.endSwitches.inputs[2] = "moteus:1:aux1.0";
    EXPECT_EQ(keysWith("moteus:1:aux1.0"), (std::vector<std::string>{upper[0], "end_switches.elevation_lower"}));
    EXPECT_TRUE(keysWith("moteus:1:aux1.1").empty());
    profile.endSwitches.inputs[2].clear();
    profile.brake.output = "rts:/dev/ttyUSB0";
    EXPECT_EQ(keysWith("cts:/dev/ttyUSB0"), upper);
    EXPECT_TRUE(keysWith("cts:/dev/ttyUSB1").empty());
    profile.mqtt.publish = Publish::On;
    EXPECT_EQ(keysWith("mqtt:boresight/state"), upper);
    EXPECT_TRUE(keysWith("mqtt:roof/end").empty());
    profile.transmit.output = "mqtt:roof/end";
    EXPECT_EQ(keysOf(crossCheck(profile)), std::vector<std::string>{"transmit.output"});
    profile.transmit.output.clear();
    profile.azimuth.driver = AxisDriver::None;
    profile.elevation.driver = AxisDriver::None;
    EXPECT_EQ(std::ranges::count(keysWith("moteus:1:aux1.1"), upper[0]), 1);
}

// Sensor and position share one connection to the broker.
// REQ-PROFILE-04
TEST(CrossCheck, APositionHasATopicOfItsOwn)
{
    Profile profile;
    profile.position.source = PositionSource::Mqtt;
    profile.sensor.source = SensorSource::Mqtt;
    EXPECT_TRUE(crossCheck(profile).empty());
    for (const std::string& topic :
         {profile.sensor.orientationTopic, profile.sensor.statusTopic, profile.sensor.calibrationTopic}) {
        profile.position.topic = topic;
        EXPECT_EQ(keysOf(crossCheck(profile)), std::vector<std::string>{"position.topic"}) << topic;
    }
    profile.sensor.source = SensorSource::None;
    EXPECT_TRUE(crossCheck(profile).empty()) << "nobody subscribes to it but the position";
}

// REQ-WIND-08: The lower limit of the wind is not above the upper one. Its topic has no other reader. The place for a
// strong wind is inside the travel and the limits, and in no keep-out.
TEST(CrossCheck, TheWindMakesSense)
{
    Profile profile;
    profile.wind.source = "mqtt:shack/wind";
    EXPECT_TRUE(crossCheck(profile).empty());
    profile.wind.releaseBelow = 15.5;
    EXPECT_EQ(keysOf(crossCheck(profile)), std::vector<std::string>{"wind.release_below_m_s"});
    profile.wind.releaseBelow = 10.0;
    profile.position.source = PositionSource::Mqtt;
    profile.position.topic = "shack/wind";
    EXPECT_EQ(keysOf(crossCheck(profile)), std::vector<std::string>{"wind.source"});
    profile.position.source = PositionSource::None;
    profile.sensor.source = SensorSource::Mqtt;
    profile.sensor.statusTopic = "shack/wind";
    EXPECT_EQ(keysOf(crossCheck(profile)), std::vector<std::string>{"wind.source"});
    profile.sensor.source = SensorSource::None;

    profile.wind.place = {.azimuth = 4000_deg, .elevation = 45_deg};
    EXPECT_TRUE(crossCheck(profile).empty()) << "it is not used";
    profile.wind.stowAt = StowAt::Place;
    EXPECT_EQ(keysOf(crossCheck(profile)), (std::vector<std::string>{"wind.azimuth_deg", "wind.azimuth_deg"}))
        << "travel and limits";
    profile.wind.place.azimuth = 30_deg;
    EXPECT_TRUE(crossCheck(profile).empty());
    profile.limits.keepOuts = {
        {.name = "mast", .azimuthFrom = 20_deg, .azimuthTo = 40_deg, .elevationMin = 30_deg, .elevationMax = 60_deg}};
    EXPECT_EQ(keysOf(crossCheck(profile)), std::vector<std::string>{"wind.elevation_deg"});
}

// REQ-PROFILE-18a: The line for the received power names an address to listen at.
TEST(CrossCheck, UdpIsListenedForAtAnAddress)
{
    Profile profile;
    EXPECT_EQ(profile.power.source, PowerSource::None);
    EXPECT_EQ(profile.power.host, "127.0.0.1") << "nobody else is listened to unless it is wanted";
    profile.power = {.source = PowerSource::Tcp, .host = "shack.local"};
    EXPECT_TRUE(crossCheck(profile).empty());
    profile.power.source = PowerSource::Udp;
    EXPECT_EQ(keysOf(crossCheck(profile)), std::vector<std::string>{"power.host"});
    profile.power.host = "0.0.0.0";
    EXPECT_TRUE(crossCheck(profile).empty());
}
