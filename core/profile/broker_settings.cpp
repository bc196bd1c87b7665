// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/control_characters.h"
#include "core/base/text.h"
#include "core/profile/setting_groups.h"
#include "core/profile/setting_makers.h"

namespace boresight::profile {

using namespace makers;

namespace {

constexpr std::size_t kLongest = 200;

Result<> checkLine(const std::string& text)
{
    if (text.size() > kLongest || hasControlCharacters(text)) {
        return failure(ErrorCode::InvalidInput, Text::tr("one line of at most 200 bytes is expected"));
    }
    return {};
}

// MQTT reserves topics that begin with '$' for the broker. '+' and '#' are wildcards, which only subscribers may use.
Result<> checkPrefix(const std::string& text)
{
    if (text.empty() || text.front() == '$' || text.find_first_of("+#") != std::string::npos) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("the beginning of a topic is expected, like \"boresight/\", without + # and $"));
    }
    return checkLine(text);
}

Setting line(const std::string& key, const Words& words, std::string BrokerSettings::*field,
             Result<> (*check)(const std::string&) = checkLine)
{
    return textual(
        key, Applies::Now, words, [field](const Profile& p) { return p.mqtt.*field; },
        [field, check](Profile& p, const std::string& wanted) {
            return check(wanted).map([&] { p.mqtt.*field = wanted; });
        });
}

void addConnection(std::vector<Setting>& list)
{
    list.push_back(
        line("mqtt.host",
             {QT_TRANSLATE_NOOP("Text", "Broker"),
              QT_TRANSLATE_NOOP("Text", "Name or address of the MQTT broker, for the sensor and for publishing.")},
             &BrokerSettings::host, checkHost));
    list.push_back(integer(
        "mqtt.port", "", {1, 65535}, Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "Port"),
         QT_TRANSLATE_NOOP("Text", "Port of the broker: usually 1883, with TLS 8883.")},
        [](auto& p) -> auto& { return p.mqtt.port; }));
    list.push_back(
        line("mqtt.user",
             {QT_TRANSLATE_NOOP("Text", "User"), QT_TRANSLATE_NOOP("Text", "User name at the broker. Empty: none.")},
             &BrokerSettings::user));
    list.push_back(line("mqtt.password",
                        {QT_TRANSLATE_NOOP("Text", "Password"),
                         QT_TRANSLATE_NOOP("Text",
                                           "Password at the broker. This file contains it as plain text, so only its "
                                           "owner may read the file. No log contains it.")},
                        &BrokerSettings::password));
    list.back().secret = true;
    list.push_back(choice(
        "mqtt.tls", offOn(), Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "TLS"),
         QT_TRANSLATE_NOOP("Text", "Encrypt the connection, and accept only a broker with a valid certificate.")},
        [](auto& p) -> auto& { return p.mqtt.tls; }));
    list.push_back(line("mqtt.ca_file",
                        {QT_TRANSLATE_NOOP("Text", "Certificate authority"),
                         QT_TRANSLATE_NOOP("Text",
                                           "With TLS: PEM file of the authority that signed the broker's certificate. "
                                           "Empty: the authorities that this computer trusts.")},
                        &BrokerSettings::caFile));
    list.push_back(line("mqtt.client_id",
                        {QT_TRANSLATE_NOOP("Text", "Client id"),
                         QT_TRANSLATE_NOOP("Text",
                                           "Name of this program at the broker. A broker disconnects the first of two "
                                           "clients with one name. Empty: a new name at every start.")},
                        &BrokerSettings::clientId));
}

void addTopics(std::vector<Setting>& list)
{
    list.push_back(choice(
        "mqtt.publish", offOn(), Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "Publish"),
         QT_TRANSLATE_NOOP(
             "Text", "Whether Boresight sends the position and the state of the mount to the broker each second.")},
        [](auto& p) -> auto& { return p.mqtt.publish; }));
    list.push_back(line(
        "mqtt.prefix",
        {QT_TRANSLATE_NOOP("Text", "Topic prefix"),
         QT_TRANSLATE_NOOP("Text",
                           "Beginning of the topics \"state\" and \"availability\" that Boresight publishes, and of "
                           "\"command\" and \"stop\" that it reads.")},
        &BrokerSettings::prefix, checkPrefix));
}

void addCommands(std::vector<Setting>& list)
{
    list.push_back(choice(
        "mqtt.commands",
        {{"off", QT_TRANSLATE_NOOP("Text", "No command")},
         {"stop", QT_TRANSLATE_NOOP("Text", "Stop and read")},
         {"drive", QT_TRANSLATE_NOOP("Text", "Move the mount")}},
        Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "Commands"),
         QT_TRANSLATE_NOOP("Text",
                           "What the topics \"command\" and \"stop\" may do. \"off\": nothing. \"stop\": stop the "
                           "mount and read its position. \"drive\": move the mount, too. Everybody who may write to "
                           "these topics of the broker has this right.")},
        [](auto& p) -> auto& { return p.mqtt.commands; }));
    list.push_back(choice(
        "mqtt.home_assistant", offOn(), Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "Home Assistant"),
         QT_TRANSLATE_NOOP("Text",
                           "Whether Home Assistant finds the mount by itself. Needs mqtt.publish. The buttons for STOP "
                           "and park appear only if mqtt.commands permits them.")},
        [](auto& p) -> auto& { return p.mqtt.homeAssistant; }));
    list.push_back(line(
        "mqtt.discovery_prefix",
        {QT_TRANSLATE_NOOP("Text", "Discovery prefix"),
         QT_TRANSLATE_NOOP("Text", "Beginning of the topics that Home Assistant searches, as in its MQTT options.")},
        &BrokerSettings::discoveryPrefix, checkPrefix));
}

}  // namespace

Result<> checkHost(const std::string& text)
{
    if (text.empty() || text.find_first_of(" /[]") != std::string::npos) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("a host name or address is expected, without port, brackets or ://"));
    }
    return checkLine(text);
}

void addBroker(std::vector<Setting>& list)
{
    addConnection(list);
    addTopics(list);
    addCommands(list);
}

bool takesReadings(const Profile& profile, const std::string& topic)
{
    const std::string name = "mqtt:" + topic;
    return profile.sensor.reads(topic) || profile.position.reads(topic) || profile.wind.source == name ||
           std::ranges::find(profile.endSwitches.inputs, name) != profile.endSwitches.inputs.end();
}

void checkBroker(std::vector<Problem>& problems, const Profile& profile)
{
    const BrokerSettings& broker = profile.mqtt;
    if (!broker.password.empty() && broker.user.empty()) {
        problems.push_back({"mqtt.user", Text::tr("is needed with a password")});
    }
    if (broker.homeAssistant == HomeAssistant::On && broker.publish == Publish::Off) {
        problems.push_back({"mqtt.home_assistant", Text::tr("needs mqtt.publish = \"on\"")});
    }
    for (const char* const name : {"command", "stop"}) {
        const std::string topic = broker.topic(name);
        if (broker.commands != BrokerCommands::Off && takesReadings(profile, topic)) {
            problems.push_back(
                {"mqtt.prefix",
                 Text::tr("the sensor, the positions, the wind or an end switch already use the topic %1")
                     .arg(toQString(topic))});
        }
    }
}

}  // namespace boresight::profile
