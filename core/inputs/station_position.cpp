// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/inputs/station_position.h"

#include "core/base/text.h"

namespace boresight {
namespace {

const QString kPositionSource = QStringLiteral("position");
constexpr int kPositionLinesPerSecond = 1;

}  // namespace

StationPosition::StationPosition(const profile::InForce& profile, EventLog& log, const Clock& clock,
                                 StationBroker& broker, QObject* parent)
    : QObject(parent),
      m_profile(profile),
      m_lines(log, clock, kPositionLinesPerSecond),
      m_inlet(QStringLiteral("position"), broker, this)
{
    connect(&m_inlet, &MessageInlet::received, this, [this](const QByteArray& message) {
        Q_EMIT received(position::readPosition({message.constData(), static_cast<std::size_t>(message.size())}));
    });
}

void StationPosition::open()
{
    close();
    m_open = true;
    const profile::PositionSettings& settings = m_profile->position;
    if (settings.source == profile::PositionSource::Udp) {
        m_inlet.openPort(toQString(settings.host), static_cast<std::uint16_t>(settings.port));
    } else if (settings.source == profile::PositionSource::Mqtt) {
        m_inlet.openTopic(toQString(settings.topic));
    }
}

void StationPosition::close()
{
    m_open = false;
    m_inlet.close();
}

void StationPosition::profileChanged(const profile::Profile& before, const profile::Profile& after)
{
    if (m_open && !after.position.comesFromWhere(before.position)) {
        open();
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
    status.trouble = m_inlet.trouble();
    switch (settings.source) {
        case profile::PositionSource::Udp:
            status.source = QStringLiteral("UDP %1:%2").arg(toQString(settings.host)).arg(settings.port);
            break;
        case profile::PositionSource::Mqtt:
            status.source = QStringLiteral("MQTT %1").arg(toQString(settings.topic));
            break;
        case profile::PositionSource::None:
            break;
    }
}

}  // namespace boresight

#include "moc_station_position.cpp"
