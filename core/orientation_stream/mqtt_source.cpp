// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/orientation_stream/mqtt_source.h"

#include "core/base/control_characters.h"
#include "core/base/text.h"
#include "core/mqtt/ending.h"

#include <QLoggingCategory>

#include <utility>

namespace boresight::orientation {
namespace {

Q_LOGGING_CATEGORY(lcMqttSensor, "boresight.sensor.mqtt")

}  // namespace

MqttSource::MqttSource(mqtt::Connection& client, const MqttTopics& topics, const Clock& clock, QObject* parent)
    : SensorSource(parent), m_client(client), m_topics(topics), m_clock(clock), m_silence(this)
{
    m_silence.setSingleShot(true);
    connect(&m_silence, &QTimer::timeout, this, &MqttSource::tellSilence);
}

MqttSource::~MqttSource()
{
    stopListening();
}

QString MqttSource::name() const
{
    return QStringLiteral("MQTT ") + mqtt::toText(m_client.broker());
}

void MqttSource::open()
{
    if (m_wanted) {
        return;
    }
    m_wanted = true;
    connect(&m_client, &mqtt::Connection::connected, this, &MqttSource::showConnection);
    connect(&m_client, &mqtt::Connection::problemChanged, this, &MqttSource::showConnection);
    connect(&m_client, &mqtt::Connection::messageReceived, this, &MqttSource::take);
    connect(&m_client, &mqtt::Connection::subscriptionRefused, this, &MqttSource::takeDenial);
    connect(&m_client, &mqtt::Connection::subscriptionGranted, this, &MqttSource::takeGrant);
    for (const QString& topic : {m_topics.orientation, m_topics.status, m_topics.calibration}) {
        m_client.subscribe(topic);
    }
    showConnection();
}

void MqttSource::close()
{
    stopListening();
    show(false, {});
}

void MqttSource::stopListening()
{
    if (!std::exchange(m_wanted, false)) {
        return;
    }
    m_client.disconnect(this);
    for (const QString& topic : {m_topics.orientation, m_topics.status, m_topics.calibration}) {
        m_client.unsubscribe(topic);
    }
    m_silence.stop();
}

void MqttSource::showConnection()
{
    const bool isConnected = m_client.isConnected();
    if (!isConnected) {
        m_silence.stop();
    } else if (!m_status.open) {
        m_refused.reset();
        m_denied.clear();
        m_denialTold = false;
        m_silence.start(m_topics.silence);
    }
    // The first good message clears a problem with the messages.
    show(isConnected, isConnected && m_status.open ? m_status.problem : m_client.problem());
}

std::optional<Topic> MqttSource::topicOf(const QString& name) const
{
    return name == m_topics.orientation   ? std::optional(Topic::Orientation)
           : name == m_topics.status      ? std::optional(Topic::Status)
           : name == m_topics.calibration ? std::optional(Topic::Calibration)
                                          : std::nullopt;
}

void MqttSource::take(const QString& name, const QByteArray& payload, mqtt::Retain retain)
{
    const auto topic = topicOf(name);
    if (!topic) {
        return;
    }
    if (retain == mqtt::Retain::Yes) {
        m_reader.refuse(Refusal::Retained);
        m_status.counts = m_reader.counts();
        m_refused = Refused{.reason = Refusal::Retained};
        return;
    }
    const auto parsed = m_reader.take(*topic, payload, m_clock.now());
    m_status.counts = m_reader.counts();
    m_status.firmware = m_reader.state();
    if (!parsed) {
        m_refused = parsed.error();
        qCDebug(lcMqttSensor) << "refused:" << toText(parsed.error()).c_str()
                              << printable(payload.toStdString()).c_str();
    } else if (*parsed) {
        m_refused.reset();
        m_denied.removeOne(m_topics.orientation);
        m_silence.start(m_topics.silence);
        showDenial();
        Q_EMIT received(**parsed);
    }
}

void MqttSource::takeDenial(const QString& topic)
{
    if (topicOf(topic) && !m_denied.contains(topic)) {
        m_denied.append(topic);
        showDenial();
    }
}

// Any other problem stays on the screen.
void MqttSource::takeGrant(const QString& topic)
{
    if (m_denied.removeOne(topic) && topic == m_topics.orientation) {
        m_silence.start(m_topics.silence);
    }
    if (m_denialTold) {
        showDenial();
    }
}

// If the orientation topic is denied, the other topics are not mentioned.
QString MqttSource::denial() const
{
    if (m_denied.isEmpty()) {
        return {};
    }
    const QString& topic = isDenied() ? m_topics.orientation : m_denied.constFirst();
    const QString& user = m_client.broker().user;
    const QString text = user.isEmpty() ? Text::tr(
                                              "%1: The broker does not permit reading %2. Permit it in the access list "
                                              "(ACL) of the broker, or set mqtt.user and mqtt.password")
                                        : Text::tr(
                                              "%1: The broker does not permit reading %2. Permit it in the access list "
                                              "(ACL) of the broker for the user \"%3\"");
    return user.isEmpty() ? text.arg(name(), topic) : text.arg(name(), topic, user);
}

void MqttSource::tellSilence()
{
    if (isDenied()) {
        return;  // already reported
    }
    m_denialTold = false;
    if (m_refused && m_refused->reason == Refusal::Retained) {
        show(true, Text::tr("%1: On %2 the broker has only an old stored value. Does the sensor have power and WiFi?")
                       .arg(name(), m_topics.orientation));
        return;
    }
    show(true, m_refused ? Text::tr("%1: The messages on %2 are not from the sensor (%3)")
                               .arg(name(), m_topics.orientation, toQString(toText(*m_refused)))
                         : Text::tr("%1: No data on %2. Does the sensor have power and WiFi? Is this its topic? Does "
                                    "the access list of the broker permit reading it?")
                               .arg(name(), m_topics.orientation));
}

void MqttSource::showDenial()
{
    show(true, denial());
    m_denialTold = true;
}

void MqttSource::show(bool open, const QString& problem)
{
    if (m_status.open != open || m_status.problem != problem) {
        m_status.open = open;
        m_status.problem = problem;
        Q_EMIT statusChanged(m_status);
    }
}

}  // namespace boresight::orientation

#include "moc_mqtt_source.cpp"
