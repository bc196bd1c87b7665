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

// What begins with '$' belongs to the broker; '+' and '#' are for those who read.
Result<> checkPrefix(const std::string& text)
{
    if (text.empty() || text.front() == '$' || text.find_first_of("+#") != std::string::npos) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("the beginning of a topic is expected, like \"boresight/\", without + # and $"));
    }
    return checkLine(text);
}

Setting line(const std::string& key, const std::string& text, std::string BrokerSettings::*field,
             Result<> (*check)(const std::string&) = checkLine)
{
    return textual(
        key, Applies::Now, text, [field](const Profile& p) { return p.mqtt.*field; },
        [field, check](Profile& p, const std::string& wanted) {
            return check(wanted).map([&] { p.mqtt.*field = wanted; });
        });
}

void addConnection(std::vector<Setting>& list)
{
    list.push_back(line(
        "mqtt.host", QT_TRANSLATE_NOOP("Text", "Name or address of the MQTT broker, for the sensor and for publish."),
        &BrokerSettings::host, checkHost));
    list.push_back(integer(
        "mqtt.port", "", {1, 65535}, Applies::Now,
        QT_TRANSLATE_NOOP("Text", "Port of the broker: mostly 1883, with TLS 8883."),
        [](auto& p) -> auto& { return p.mqtt.port; }));
    list.push_back(line("mqtt.user", QT_TRANSLATE_NOOP("Text", "User name at the broker; empty: without."),
                        &BrokerSettings::user));
    list.push_back(line("mqtt.password",
                        QT_TRANSLATE_NOOP("Text",
                                          "Password at the broker. It stands in this file as it is, which only its "
                                          "owner may then read, and in no log."),
                        &BrokerSettings::password));
    list.back().secret = true;
    list.push_back(choice(
        "mqtt.tls", {"off", "on"}, Applies::Now,
        QT_TRANSLATE_NOOP("Text", "Encrypted, and only with a broker whose certificate is right."),
        [](auto& p) -> auto& { return p.mqtt.tls; }));
    list.push_back(line("mqtt.ca_file",
                        QT_TRANSLATE_NOOP("Text",
                                          "With TLS: PEM file of the authority that signed the broker's certificate; "
                                          "empty: those that this computer knows."),
                        &BrokerSettings::caFile));
    list.push_back(line("mqtt.client_id",
                        QT_TRANSLATE_NOOP("Text",
                                          "Name of this program at the broker, which throws out the first of two of "
                                          "one name; empty: another one at every start."),
                        &BrokerSettings::clientId));
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
    list.push_back(choice(
        "mqtt.publish", {"off", "on"}, Applies::Now,
        QT_TRANSLATE_NOOP("Text",
                          "Whether Boresight tells the broker each second where the mount is and what it does."),
        [](auto& p) -> auto& { return p.mqtt.publish; }));
    list.push_back(line("mqtt.prefix",
                        QT_TRANSLATE_NOOP("Text", "Beginning of the topics state and availability that it publishes."),
                        &BrokerSettings::prefix, checkPrefix));
}

}  // namespace boresight::profile
