// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mqtt/home_assistant.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>

#include <gmock/gmock.h>

#include <algorithm>
#include <set>
#include <vector>

namespace boresight::mqtt {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Described roof(Offered buttons)
{
    return {.discoveryPrefix = QStringLiteral("homeassistant"),
            .prefix = QStringLiteral("boresight/"),
            .name = QStringLiteral("Roof"),
            .version = QStringLiteral("0.1"),
            .buttons = buttons};
}

// The payload on this topic, or "absent" if there is none.
std::string payload(const std::vector<Message>& all, const char* topic)
{
    const auto found = std::ranges::find(all, QLatin1String(topic), &Message::topic);
    return found == all.end() ? "absent" : found->payload.toStdString();
}

QJsonObject objectOf(const Message& message)
{
    return QJsonDocument::fromJson(message.payload).object();
}

// REQ-MQTT-11 (HomeAssistant.*): Home Assistant finds the mount by retained messages of its MQTT discovery: position,
// state, target, alarms, motion, fault, STOP and link. Values expire after 10 s, and the availability counts for all.
TEST(HomeAssistant, ReadsAValueOfTheState)
{
    const auto all = discovery(roof(Offered::Nothing));
    EXPECT_EQ(payload(all, "homeassistant/sensor/boresight_azimuth/config"),
              R"({"availability_topic":"boresight/availability",)"
              R"("device":{"identifiers":["boresight"],"manufacturer":"Boresight","model":"Antenna mount",)"
              R"("name":"Roof","sw_version":"0.1"},"expire_after":10,"name":"Azimuth",)"
              R"("origin":{"name":"Boresight","sw_version":"0.1"},"state_class":"measurement",)"
              R"("state_topic":"boresight/state","suggested_display_precision":1,)"
              R"("unique_id":"boresight_azimuth","unit_of_measurement":"°",)"
              R"("value_template":"{{ value_json.azimuth }}"})");
    EXPECT_EQ(payload(all, "homeassistant/binary_sensor/boresight_link/config"),
              R"({"availability_topic":"boresight/availability",)"
              R"("device":{"identifiers":["boresight"],"manufacturer":"Boresight","model":"Antenna mount",)"
              R"("name":"Roof","sw_version":"0.1"},"device_class":"connectivity","expire_after":10,"name":"Link",)"
              R"("origin":{"name":"Boresight","sw_version":"0.1"},"state_topic":"boresight/state",)"
              R"("unique_id":"boresight_link","value_template":"{{ 'ON' if value_json.link.up else 'OFF' }}"})");
    std::vector<std::string> described;
    for (const Message& one : all) {
        EXPECT_EQ(one.retain, Retain::Yes);
        if (!one.payload.isEmpty()) {
            described.push_back(one.topic.section(QLatin1Char('/'), 1, 2).toStdString());
        }
    }
    EXPECT_THAT(described, ElementsAre("sensor/boresight_azimuth", "sensor/boresight_elevation",
                                       "sensor/boresight_state", "sensor/boresight_target", "sensor/boresight_alarms",
                                       "binary_sensor/boresight_moving", "binary_sensor/boresight_fault",
                                       "binary_sensor/boresight_stop_latched", "binary_sensor/boresight_link"));
}

// REQ-MQTT-12: Buttons for STOP and Park are offered if `mqtt.commands` permits them. A button that is not offered is
// removed by an empty message.
TEST(HomeAssistant, OffersButtonsAsFarAsCommandsAreOn)
{
    const char* const stop = "homeassistant/button/boresight_stop/config";
    const char* const park = "homeassistant/button/boresight_park/config";
    const char* const answer = "homeassistant/sensor/boresight_answer/config";
    const auto none = discovery(roof(Offered::Nothing));
    EXPECT_EQ(payload(none, stop), "");
    EXPECT_EQ(payload(none, park), "");
    EXPECT_EQ(payload(none, answer), "");
    const auto stopping = discovery(roof(Offered::Stop));
    EXPECT_EQ(payload(stopping, stop),
              R"({"availability_topic":"boresight/availability","command_topic":"boresight/stop",)"
              R"("device":{"identifiers":["boresight"],"manufacturer":"Boresight","model":"Antenna mount",)"
              R"("name":"Roof","sw_version":"0.1"},"icon":"mdi:alert-octagon","name":"STOP",)"
              R"("origin":{"name":"Boresight","sw_version":"0.1"},"payload_press":"stop",)"
              R"("unique_id":"boresight_stop"})");
    EXPECT_EQ(payload(stopping, park), "");
    EXPECT_EQ(payload(stopping, answer),
              R"({"availability_topic":"boresight/availability",)"
              R"("device":{"identifiers":["boresight"],"manufacturer":"Boresight","model":"Antenna mount",)"
              R"("name":"Roof","sw_version":"0.1"},"entity_category":"diagnostic","name":"Last answer",)"
              R"("origin":{"name":"Boresight","sw_version":"0.1"},"state_topic":"boresight/answer",)"
              R"("unique_id":"boresight_answer","value_template":"{{ value_json.answer[:250] }}"})");
    const auto driving = discovery(roof(Offered::StopAndPark));
    EXPECT_EQ(payload(driving, park),
              R"({"availability_topic":"boresight/availability","command_topic":"boresight/command",)"
              R"("device":{"identifiers":["boresight"],"manufacturer":"Boresight","model":"Antenna mount",)"
              R"("name":"Roof","sw_version":"0.1"},"icon":"mdi:parking","name":"Park",)"
              R"("origin":{"name":"Boresight","sw_version":"0.1"},"payload_press":"park",)"
              R"("unique_id":"boresight_park"})");
    for (const Message& one : driving) {
        EXPECT_FALSE(objectOf(one)[QStringLiteral("retain")].toBool()) << "a command is never kept";
    }
}

// Each entity meets the rules of the documentation: a topic of the allowed characters, a unique id, and a device.
TEST(HomeAssistant, IsToldByTheRules)
{
    for (const char* const prefix : {"boresight/", "boresight", "/a/b/", "shack/größe 2/", "$", "roof"}) {
        Described mount = roof(Offered::StopAndPark);
        mount.prefix = QString::fromUtf8(prefix);
        mount.discoveryPrefix = QStringLiteral("ha/found/");
        std::set<QString> topics;
        std::set<QString> ids;
        for (const Message& one : discovery(mount)) {
            static const QRegularExpression kRule(
                QStringLiteral("^ha/found/(sensor|binary_sensor|button)/[a-zA-Z0-9_-]+/config$"));
            EXPECT_TRUE(kRule.match(one.topic).hasMatch()) << one.topic.toStdString();
            const QJsonObject all = objectOf(one);
            EXPECT_TRUE(topics.insert(one.topic).second);
            EXPECT_TRUE(ids.insert(all[QStringLiteral("unique_id")].toString()).second);
            EXPECT_FALSE(all[QStringLiteral("device")].toObject()[QStringLiteral("identifiers")].toArray().isEmpty());
            EXPECT_FALSE(all[QStringLiteral("availability_topic")].toString().contains(QStringLiteral("//")));
        }
        EXPECT_EQ(topics.size(), 12U);
    }
}

// Story: the mounts "a/b" and "a_b" had one id, so each of them overwrote the entities of the other one.
// REQ-MQTT-15: Mounts with different prefixes have different entities, whatever characters the prefixes have. A prefix
// with and without "/" at its end is the same one.
TEST(HomeAssistant, TellsMountsApart)
{
    const auto topicsOf = [](const char* prefix) {
        Described mount = roof(Offered::StopAndPark);
        mount.prefix = QString::fromUtf8(prefix);
        std::set<QString> topics;
        for (const Message& one : discovery(mount)) {
            topics.insert(one.topic);
            topics.insert(objectOf(one)[QStringLiteral("unique_id")].toString());
        }
        return topics;
    };
    std::set<QString> all;
    std::size_t each = 0;
    const std::vector<const char*> prefixes = {
        "boresight",       "boresight/a/b", "boresight/a_b",  "boresight_a_b", "boresight_a/b", "boresight/größe",
        "boresight/grüße", "roof",          "boresight_roof", "ro/of",         "ro of",         "boresight/ro of"};
    for (const char* const prefix : prefixes) {
        const std::set<QString> topics = topicsOf(prefix);
        each = topics.size();
        all.insert(topics.begin(), topics.end());
    }
    EXPECT_EQ(all.size(), prefixes.size() * each);
    EXPECT_EQ(topicsOf("boresight/a"), topicsOf("boresight/a/"));
    EXPECT_TRUE(topicsOf("boresight/").contains(QStringLiteral("boresight_azimuth"))) << "the usual one is short";
}

// REQ-MQTT-13: Entities that were announced under another prefix or at another broker, or are not wanted any more, are
// removed. If the broker is away then, they are removed at the next connection to it while the program runs. The others
// stay, with the settings that the user of Home Assistant has made for them.
TEST(HomeAssistant, ForgetsWhatIsGone)
{
    const auto before = discovery(roof(Offered::Stop));
    EXPECT_THAT(withdrawal(before, discovery(roof(Offered::StopAndPark))), IsEmpty());
    const auto gone = withdrawal(before, {});
    ASSERT_EQ(gone.size(), 11U) << "park was never there";
    for (const Message& one : gone) {
        EXPECT_TRUE(one.payload.isEmpty());
        EXPECT_EQ(one.retain, Retain::Yes);
    }
    Described moved = roof(Offered::Stop);
    moved.prefix = QStringLiteral("roof");
    EXPECT_EQ(withdrawal(before, discovery(moved)).size(), 11U);
    EXPECT_THAT(withdrawal({}, before), IsEmpty());
}

}  // namespace
}  // namespace boresight::mqtt
