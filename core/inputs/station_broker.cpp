// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/inputs/station_broker.h"

#include "core/alarms/catalogue.h"
#include "core/base/text.h"
#include "core/base/version.h"
#include "core/messages/state_word.h"
#include "core/mqtt/ending.h"
#include "core/mqtt/home_assistant.h"
#include "core/mqtt/profile_broker.h"

#include <QUuid>

#include <algorithm>
#include <iterator>
#include <utility>

namespace boresight {
namespace {

const QString kBrokerSource = QStringLiteral("mqtt");
constexpr int kBrokerLinesPerSecond = 1;
constexpr qint64 kKilobyte = 1024;

// As for rotctld clients: an older position does not count, nor does one on an unknown cable wrap.
constexpr std::chrono::seconds kPositionAge{1};

std::optional<Angle> place(const AxisStatus& axis)
{
    return axis.age && *axis.age < kPositionAge && axis.turnKnown ? axis.actual : std::nullopt;
}

bool answers(const AxisStatus& axis)
{
    return axis.state == AxisState::Missing || (axis.age && *axis.age < kPositionAge);
}

std::vector<mqtt::PublishedAlarm> alarmsOf(const StationStatus& status)
{
    std::vector<mqtt::PublishedAlarm> all;
    for (const Alarm& alarm : status.alarms) {
        if (alarm.active) {
            all.push_back(
                {.id = alarm.name, .about = alarm.about, .severity = severityWord(alarm.severity), .text = alarm.what});
        }
    }
    return all;
}

std::optional<mqtt::PublishedBrake> brakeOf(const BrakeStatus& brake)
{
    return brake.output.isEmpty()
               ? std::nullopt
               : std::optional(mqtt::PublishedBrake{.state = protocolWord(brake), .problem = brake.problem});
}

std::vector<mqtt::PublishedSwitch> switchesOf(const StationStatus& status)
{
    std::vector<mqtt::PublishedSwitch> all;
    for (const EndSwitchStatus& one : status.endSwitches) {
        all.push_back({.end = protocolWord(one.which), .state = protocolWord(one.state), .problem = one.problem});
    }
    return all;
}

mqtt::PublishedState published(const StationStatus& status)
{
    const auto azimuth = place(status.azimuth);
    const auto elevation = place(status.elevation);
    return {.utc = status.utc,
            .state = protocolWord(status.state),
            .fault = status.state == StationState::Fault ? status.stateReason : QString(),
            .stopLatched = status.stopLatched,
            .limited = status.limited,
            .simulated = status.simulated,
            .actual = azimuth && elevation ? status.actual : std::nullopt,
            .commanded = status.commanded,
            .target = status.target,
            .azimuthAxis = azimuth,
            .elevationAxis = elevation,
            .targetText = status.targetText,
            .commander = status.commander.name,
            .isLinked = answers(status.azimuth) && answers(status.elevation),
            .linkProblem = status.line.problem,
            .brake = brakeOf(status.brake),
            .endSwitches = switchesOf(status),
            .alarms = alarmsOf(status)};
}

mqtt::Offered offeredBy(profile::BrokerCommands commands)
{
    switch (commands) {
        case profile::BrokerCommands::Stop:
            return mqtt::Offered::Stop;
        case profile::BrokerCommands::Drive:
            return mqtt::Offered::StopAndPark;
        case profile::BrokerCommands::Off:
            break;
    }
    return mqtt::Offered::Nothing;
}

// The description for Home Assistant. Empty if it is not wanted.
std::vector<mqtt::Message> descriptionOf(const profile::Profile& profile)
{
    const profile::BrokerSettings& settings = profile.mqtt;
    if (settings.homeAssistant == profile::HomeAssistant::Off || settings.publish == profile::Publish::Off) {
        return {};
    }
    return mqtt::discovery({.discoveryPrefix = toQString(settings.discoveryPrefix),
                            .prefix = toQString(settings.prefix),
                            .name = toQString(profile.mount.name),
                            .version = toQString(kVersion),
                            .buttons = offeredBy(settings.commands)});
}

// A problem may end with a question.
QString ended(const QString& problem)
{
    return problem.endsWith(QLatin1Char('?')) ? problem : problem + QLatin1Char('.');
}

std::pair<std::string, int> addressOf(const profile::BrokerSettings& settings)
{
    return {settings.host, settings.port};
}

}  // namespace

StationBroker::StationBroker(const profile::InForce& profile, EventLog& log, const Clock& clock, QObject* parent)
    : QObject(parent),
      m_profile(profile),
      m_log(log),
      m_clock(clock),
      m_ownId(QStringLiteral("boresight-") + QUuid::createUuid().toString(QUuid::Id128).left(8)),
      m_lines(log, clock, kBrokerLinesPerSecond),
      m_client(clock, this),
      m_description(descriptionOf(*profile))
{
    connect(&m_client, &mqtt::Connection::connected, this, [this] {
        m_log.add(Severity::Advisory, kBrokerSource,
                  Text::tr("connected to the broker %1").arg(mqtt::toText(m_client.broker())));
        withdrawOwed();
        publishAll(m_description);
    });
    connect(&m_client, &mqtt::Connection::problemChanged, this, [this](const QString& problem) {
        if (!problem.isEmpty()) {
            m_log.add(Severity::Warning, kBrokerSource,
                      Text::tr("%1 Boresight tries again at least every 30 s").arg(ended(problem)));
        }
    });
    connect(&m_client, &mqtt::Connection::messageDropped, this, [this](qint64 bytes) {
        m_lines.add(Severity::Warning, kBrokerSource,
                    Text::tr("MQTT broker %1: a message of %2 kB was dropped. The limit is %3 kB")
                        .arg(mqtt::toText(m_client.broker()))
                        .arg(bytes / kKilobyte)
                        .arg(mqtt::kLargestMessage / kKilobyte));
    });
}

void StationBroker::profileChanged(const profile::Profile& before, const profile::Profile& after)
{
    if (before.mqtt != after.mqtt) {
        stopPublishing();
        describe(before, after);
    }
    connectAnew();
}

// The connection is still the one to the broker of `before`. Another broker gets the description when it is connected.
void StationBroker::describe(const profile::Profile& before, const profile::Profile& after)
{
    const std::vector<mqtt::Message> described = std::exchange(m_description, descriptionOf(after));
    const bool isSame = addressOf(before.mqtt) == addressOf(after.mqtt);
    const auto gone = mqtt::withdrawal(described, isSame ? m_description : std::vector<mqtt::Message>());
    if (!m_client.isConnected()) {
        std::ranges::copy(gone, std::back_inserter(m_owed[addressOf(before.mqtt)]));
        return;
    }
    publishAll(gone);
    if (isSame) {
        publishAll(m_description);
    }
}

// An entity that is described again by now stays.
void StationBroker::withdrawOwed()
{
    if (const auto owed = m_owed.extract(addressOf(m_profile->mqtt))) {
        for (const mqtt::Message& gone : owed.mapped()) {
            if (std::ranges::find(m_description, gone.topic, &mqtt::Message::topic) == m_description.end()) {
                m_client.publish(gone);
            }
        }
    }
}

void StationBroker::publishAll(const std::vector<mqtt::Message>& messages)
{
    for (const mqtt::Message& message : messages) {
        m_client.publish(message);
    }
}

void StationBroker::setSensorWanted(bool wanted)
{
    m_sensorWanted = wanted;
    connectAnew();
}

void StationBroker::addReader()
{
    ++m_readers;
    connectAnew();
}

void StationBroker::removeReader()
{
    --m_readers;
    connectAnew();
}

void StationBroker::connectAnew()
{
    const bool publishes = m_profile->mqtt.publish == profile::Publish::On;
    if (!publishes && !isReadFrom()) {
        m_client.close();
        return;
    }
    const QString prefix = toQString(m_profile->mqtt.prefix);
    m_client.open(mqtt::brokerOf(m_profile->mqtt, m_ownId),
                  publishes ? std::optional(mqtt::StatePublisher::will(prefix)) : std::nullopt);
    if (publishes && !m_publisher) {
        m_publisher = std::make_unique<mqtt::StatePublisher>(m_client, m_clock, prefix);
    }
}

void StationBroker::stopPublishing()
{
    if (m_publisher) {
        m_publisher->sayOffline();
        m_publisher.reset();
    }
}

void StationBroker::close()
{
    stopPublishing();
    m_client.close();
}

void StationBroker::show(const StationStatus& status)
{
    if (m_publisher) {
        m_publisher->show(published(status));
    }
}

void StationBroker::tell(const QByteArray& momentOfTheSchedule)
{
    if (isPublishing()) {
        m_publisher->tell(momentOfTheSchedule);
    }
}

std::optional<Seconds> StationBroker::untilNext() const
{
    const auto& next = m_client.nextAttempt();
    return next ? std::optional(std::max(Seconds(*next - m_clock.now()), Seconds(0.0))) : std::nullopt;
}

BrokerStatus StationBroker::status() const
{
    const bool isWanted = m_profile->mqtt.publish == profile::Publish::On || isReadFrom();
    return {.wanted = isWanted,
            .connected = m_client.isConnected(),
            .name = isWanted ? mqtt::toText(m_client.broker()) : QString(),
            .problem = m_client.problem(),
            .retryIn = untilNext()};
}

}  // namespace boresight

#include "moc_station_broker.cpp"
