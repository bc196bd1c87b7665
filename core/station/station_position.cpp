// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/station_position.h"

#include "core/base/text.h"

namespace boresight {
namespace {

const QString kPositionSource = QStringLiteral("position");
constexpr int kPositionLinesPerSecond = 1;

}  // namespace

StationPosition::StationPosition(const profile::InForce& profile, EventLog& log, const Clock& clock,
                                 StationBroker& broker, QObject* parent)
    : QObject(parent), m_profile(profile), m_lines(log, clock, kPositionLinesPerSecond), m_broker(broker)
{
    connect(&m_broker.connection(), &mqtt::Connection::messageReceived, this, &StationPosition::takeMessage);
}

void StationPosition::open()
{
    close();
    m_open = true;
    const profile::PositionSettings& settings = m_profile->position;
    if (settings.source == profile::PositionSource::Udp) {
        m_port = std::make_unique<position::PositionPort>(toQString(settings.host),
                                                          static_cast<std::uint16_t>(settings.port));
        connect(m_port.get(), &position::PositionPort::received, this, &StationPosition::received);
    } else if (settings.source == profile::PositionSource::Mqtt) {
        m_topic = toQString(settings.topic);
        m_broker.connection().subscribe(m_topic);
        m_broker.setPositionWanted(true);
    }
}

void StationPosition::close()
{
    m_open = false;
    m_port.reset();
    if (!m_topic.isEmpty()) {
        m_broker.connection().unsubscribe(m_topic);
        m_topic.clear();
        m_broker.setPositionWanted(false);
    }
}

void StationPosition::profileChanged(const profile::Profile& before, const profile::Profile& after)
{
    if (m_open && !after.position.comesFromWhere(before.position)) {
        open();
    }
}

// One that the broker has kept is of some time before.
void StationPosition::takeMessage(const QString& topic, const QByteArray& payload, mqtt::Retain retain)
{
    if (!m_topic.isEmpty() && topic == m_topic && retain == mqtt::Retain::No) {
        Q_EMIT received(position::readPosition({payload.constData(), static_cast<std::size_t>(payload.size())}));
    }
}

void StationPosition::tellRefused(const Error& why)
{
    if (why.code != ErrorCode::NotAvailable) {
        m_lines.add(Severity::Warning, kPositionSource, Text::tr("a position was refused: %1").arg(why.text));
    }
}

void StationPosition::describe(PositionStatus& status) const
{
    const profile::PositionSettings& settings = m_profile->position;
    switch (settings.source) {
        case profile::PositionSource::Udp:
            status.source = QStringLiteral("UDP %1:%2").arg(toQString(settings.host)).arg(settings.port);
            status.trouble = m_port ? m_port->trouble() : QString();
            break;
        case profile::PositionSource::Mqtt:
            status.source = QStringLiteral("MQTT %1").arg(toQString(settings.topic));
            status.trouble = m_broker.status().problem;
            break;
        case profile::PositionSource::None:
            break;
    }
}

}  // namespace boresight

#include "moc_station_position.cpp"
