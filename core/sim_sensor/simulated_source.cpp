// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim_sensor/simulated_source.h"

#include "core/sim_sensor/sensor_box.h"

#include <utility>

namespace boresight {

SimulatedSource::SimulatedSource(const Clock& clock, std::shared_ptr<SimulatedMount> mount, QObject* parent)
    : SensorSource(parent), m_clock(clock), m_mount(std::move(mount))
{
    m_timer.setInterval(sim::SimulatedSensor::kReadingPeriod);
    connect(&m_timer, &QTimer::timeout, this, &SimulatedSource::read);
}

void SimulatedSource::open()
{
    m_timer.start();
    setOpen(true);
}

void SimulatedSource::close()
{
    m_timer.stop();
    setOpen(false);
}

void SimulatedSource::read()
{
    const auto message = sim::readOn(m_mount->pair, m_mount->epoch, m_clock, m_mount->sensor);
    if (!message) {
        return;
    }
    m_stream.add(sim::toSentence(*message), m_clock.now(), [this](orientation::Orientation value) {
        value.transport = orientation::Transport::Simulated;
        m_status.counts = m_stream.counts();
        Q_EMIT received(value);
    });
}

void SimulatedSource::setOpen(bool open)
{
    if (m_status.open != open) {
        m_status.open = open;
        Q_EMIT statusChanged(m_status);
    }
}

}  // namespace boresight

#include "moc_simulated_source.cpp"
