// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/message_commands.h"

#include "core/alarms/catalogue.h"
#include "core/base/peer_address.h"
#include "core/base/text.h"

#include <utility>

namespace boresight {
namespace {

const std::string kMqttProtocol = "MQTT";

// A message that the broker kept is refused, so it never replaces a live one.
mqtt::Urgency urgencyOf(mqtt::Message& message, const QString& command, const QString& stop)
{
    if (message.retain == mqtt::Retain::Yes) {
        return mqtt::Urgency::None;
    }
    if (message.topic == stop) {
        message.payload.clear();  // any text means STOP
        return mqtt::Urgency::Stop;
    }
    return message.topic == command ? mqtt::CommandTalk::urgencyOf(message.payload) : mqtt::Urgency::None;
}

}  // namespace

MessageCommands::MessageCommands(AlarmBoard& alarms, const profile::InForce& profile, EventLog& log, const Clock& clock,
                                 StationBroker& broker, rotctld::Rotator& rotator,
                                 std::shared_ptr<std::uint64_t> newestClient, mqtt::LatchStop latchStop,
                                 QObject* parent)
    : QObject(parent),
      m_alarms(alarms),
      m_profile(profile),
      m_log(log),
      m_clock(clock),
      m_broker(broker),
      m_rotator(rotator),
      m_newestClient(std::move(newestClient)),
      m_latchStop(std::move(latchStop))
{
    mqtt::Connection& connection = m_broker.connection();
    connect(&connection, &mqtt::Connection::connected, this, &MessageCommands::begin);
    connect(&connection, &mqtt::Connection::messageReceived, this, &MessageCommands::take);
    connect(&connection, &mqtt::Connection::subscriptionRefused, this, [this](const QString& topic) {
        if (!topic.isEmpty() && (topic == m_commandTopic || topic == m_stopTopic)) {
            m_log.add(Severity::Warning, QStringLiteral("mqtt"),
                      Text::tr("The broker does not let Boresight read the topic %1. No command arrives. Permit this "
                               "topic in the access list of the broker.")
                          .arg(topic));
        }
    });
}

void MessageCommands::open()
{
    close();
    tellOpenBroker();
    if (m_profile->mqtt.commands == profile::BrokerCommands::Off) {
        return;
    }
    m_commandTopic = toQString(m_profile->mqtt.topic("command"));
    m_stopTopic = toQString(m_profile->mqtt.topic("stop"));
    m_answerTopic = toQString(m_profile->mqtt.topic("answer"));
    m_broker.keepUrgent([command = m_commandTopic, stop = m_stopTopic](mqtt::Message& message) {
        return urgencyOf(message, command, stop);
    });
    m_broker.connection().subscribe(m_commandTopic);
    m_broker.connection().subscribe(m_stopTopic);
    m_broker.addReader();
    if (m_broker.connection().isConnected()) {
        begin();
    }
}

void MessageCommands::close()
{
    if (m_commandTopic.isEmpty()) {
        return;
    }
    end(Text::tr("Boresight no longer reads commands by MQTT"));
    m_broker.connection().unsubscribe(m_commandTopic);
    m_broker.connection().unsubscribe(m_stopTopic);
    m_broker.keepUrgent({});
    m_commandTopic.clear();
    m_stopTopic.clear();
    m_answerTopic.clear();
    m_broker.removeReader();
}

void MessageCommands::profileChanged(const profile::Profile& before, const profile::Profile& after)
{
    if (before.mqtt.commands != after.mqtt.commands || before.mqtt.prefix != after.mqtt.prefix) {
        open();
    } else {
        tellOpenBroker();
    }
}

// Boresight connects without a user name, so everybody who reaches the broker can probably send commands.
void MessageCommands::tellOpenBroker()
{
    const profile::BrokerSettings& settings = m_profile->mqtt;
    if (settings.commands != profile::BrokerCommands::Drive || !settings.user.empty() ||
        isThisComputer(settings.host)) {
        m_alarms.clear(alarmEntry("mqtt.open"));
        return;
    }
    m_alarms.raise(alarmEntry("mqtt.open"), {QStringLiteral("%1:%2").arg(toQString(settings.host)).arg(settings.port)});
}

void MessageCommands::tick()
{
    if (m_talk && !m_broker.connection().isConnected()) {
        end(Text::tr("the connection to the broker is lost"));
    }
    if (m_talk) {
        m_talk->tick();
    }
}

bool MessageCommands::disconnect(std::uint64_t client, const QString& reason)
{
    if (!m_talk || m_talk->client().id != client) {
        return false;
    }
    end(reason);
    begin();
    return true;
}

std::vector<rotctld::ClientInfo> MessageCommands::clients() const
{
    if (!m_talk) {
        return {};
    }
    return {infoOf(m_talk->client(), m_talk->habits(), m_clock.now())};
}

// The address of this client is a topic, not a computer. A profile can therefore not lock the mount to this client.
void MessageCommands::begin()
{
    if (m_commandTopic.isEmpty()) {
        return;
    }
    end(Text::tr("Boresight connected to the broker again"));
    m_talk = std::make_shared<mqtt::CommandTalk>(
        rotctld::Client{.id = ++*m_newestClient,
                        .address = "topic " + m_commandTopic.toStdString(),
                        .protocol = kMqttProtocol,
                        .readsOnly = m_profile->mqtt.commands == profile::BrokerCommands::Stop,
                        .keepsControlByReading = false},
        m_rotator, m_clock,
        [this] { return m_profile->site.known ? std::optional(m_profile->site.place()) : std::nullopt; }, m_latchStop);
    m_rotator.clientConnected(m_talk->client());
}

void MessageCommands::end(const QString& reason)
{
    if (const auto talk = std::exchange(m_talk, nullptr)) {
        m_rotator.clientGone(talk->client(), reason);
    }
}

void MessageCommands::take(const QString& topic, const QByteArray& payload, mqtt::Retain retain)
{
    const std::shared_ptr<mqtt::CommandTalk> talk = m_talk;  // STOP runs a tick at once, and the tick may reset m_talk
    if (!talk || (topic != m_commandTopic && topic != m_stopTopic)) {
        return;
    }
    const auto answer = topic == m_stopTopic ? talk->stop(payload, retain) : talk->obey(payload, retain);
    if (answer) {
        m_broker.connection().publish({.topic = m_answerTopic, .payload = *answer});
    }
}

}  // namespace boresight

#include "moc_message_commands.cpp"
