// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mount/paired_connection.h"

#include <utility>

namespace boresight {

PairedConnection::PairedConnection(std::unique_ptr<MountConnection> azimuth, std::unique_ptr<MountConnection> elevation)
    : m_azimuth(std::move(azimuth)),
      m_elevation(std::move(elevation)),
      m_mount(m_azimuth->driver(), m_elevation->driver())
{
    m_azimuth->setParent(this);  // so that they move to the station thread together with this object
    m_elevation->setParent(this);
}

PairedConnection::~PairedConnection()
{
    m_azimuth->setParent(nullptr);
    m_elevation->setParent(nullptr);
}

const Result<>& PairedConnection::mine() const
{
    return m_azimuth->mine() ? m_elevation->mine() : m_azimuth->mine();
}

void PairedConnection::open()
{
    m_azimuth->open();
    m_elevation->open();
}

void PairedConnection::close()
{
    m_azimuth->close();
    m_elevation->close();
}

void PairedConnection::send()
{
    m_azimuth->send();
    m_elevation->send();
}

Result<> PairedConnection::admits(const Request& request) const
{
    return m_azimuth->admits(request).and_then([&] { return m_elevation->admits(request); });
}

Result<> PairedConnection::carryOut(const Request& request)
{
    return m_azimuth->carryOut(request).and_then([&] { return m_elevation->carryOut(request); });
}

void PairedConnection::profileChanged(const profile::Profile& before, const profile::Profile& after)
{
    m_azimuth->profileChanged(before, after);
    m_elevation->profileChanged(before, after);
}

void PairedConnection::setCourse(const std::optional<SensorCourse>& course)
{
    m_azimuth->setCourse(course);
    m_elevation->setCourse(course);
}

contacts::InputReading PairedConnection::pin(const contacts::BoardPin& pin) const
{
    contacts::InputReading reading = m_azimuth->pin(pin);
    return reading.isOn ? reading : m_elevation->pin(pin);
}

std::unique_ptr<outputs::Output> PairedConnection::pinOutput(const contacts::BoardPin& pin)
{
    auto output = m_azimuth->pinOutput(pin);
    return output ? std::move(output) : m_elevation->pinOutput(pin);
}

void PairedConnection::describe(StationStatus& status) const
{
    m_azimuth->describe(status);
    const MountLine azimuth = std::exchange(status.line, {});
    m_elevation->describe(status);
    const bool azimuthWorks = azimuth.kind.isEmpty() || azimuth.state == MountLine::State::Up;
    if (!azimuthWorks || status.line.kind.isEmpty()) {
        status.line = azimuth;
    }
}

MountMaker pairOf(const MountMaker& azimuth, const MountMaker& elevation)
{
    return
        [azimuth, elevation](const profile::InForce& profile, const Clock& clock, EventLog& log, AlarmBoard& alarms) {
            return std::make_unique<PairedConnection>(azimuth(profile, clock, log, alarms),
                                                      elevation(profile, clock, log, alarms));
        };
}

}  // namespace boresight

#include "moc_paired_connection.cpp"
