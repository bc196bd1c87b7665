// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/inputs/station_wind.h"

#include "core/base/text.h"
#include "core/wind/wind_source.h"

namespace boresight {
namespace {

const QString kWindSource = QStringLiteral("wind");
constexpr int kWindLinesPerSecond = 1;

}  // namespace

StationWind::StationWind(const profile::InForce& profile, EventLog& log, const Clock& clock, StationBroker& broker,
                         QObject* parent)
    : QObject(parent), m_profile(profile), m_lines(log, clock, kWindLinesPerSecond), m_inlet(kWindSource, broker, this)
{
    connect(&m_inlet, &MessageInlet::received, this, &StationWind::take);
}

void StationWind::open()
{
    close();
    m_open = true;
    m_refused = 0;
    m_refusal.clear();
    const wind::SourceName source = wind::parseSource(m_profile->wind.source).value_or(wind::SourceName{});
    switch (source.kind) {
        case wind::SourceKind::None:
            break;
        case wind::SourceKind::Udp:
            m_inlet.openPort(source.place, source.port);
            break;
        case wind::SourceKind::Mqtt:
            m_inlet.openTopic(source.place);
            break;
        case wind::SourceKind::Page:
            m_inlet.openPage(QUrl(source.place), std::chrono::round<std::chrono::milliseconds>(m_profile->wind.poll));
            break;
    }
}

void StationWind::close()
{
    m_open = false;
    m_inlet.close();
}

void StationWind::profileChanged(const profile::Profile& before, const profile::Profile& after)
{
    if (m_open && (before.wind.source != after.wind.source || before.wind.poll != after.wind.poll)) {
        open();
    }
}

void StationWind::take(const QByteArray& message)
{
    const Result<double> speed =
        wind::readWind({message.constData(), static_cast<std::size_t>(message.size())}, m_profile->wind.format);
    if (speed) {
        Q_EMIT measured(*speed);
        return;
    }
    ++m_refused;
    m_refusal = speed.error().text;
    m_lines.add(Severity::Warning, kWindSource, Text::tr("a reading was refused: %1").arg(m_refusal));
}

void StationWind::describe(WindStatus& status) const
{
    status.trouble = m_inlet.trouble();
    status.refused = m_refused;
    status.refusal = m_refusal;
}

}  // namespace boresight

#include "moc_station_wind.cpp"
