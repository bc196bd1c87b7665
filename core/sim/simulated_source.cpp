// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim/simulated_source.h"

#include <cmath>
#include <utility>

namespace boresight {

SimulatedSource::SimulatedSource(const Clock& clock, std::shared_ptr<SimulatedMount> mount, QObject* parent)
    : Source(parent), m_clock(clock), m_mount(std::move(mount))
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
    const SteadyTime now = m_clock.now();
    sim::SimulatedPair& pair = m_mount->pair;
    pair.advanceTo(now - m_mount->epoch);
    const sim::AxisTruth azimuth = pair.truth(Axis::Azimuth);
    const sim::AxisTruth elevation = pair.truth(Axis::Elevation);
    const auto message =
        m_mount->sensor.read(now, m_clock.utc(), {.azimuth = azimuth.angle, .elevation = elevation.angle},
                             std::abs(azimuth.current) + std::abs(elevation.current));
    if (!message) {
        return;
    }
    m_stream.add(sim::toSentence(*message), now, [this](orientation::Orientation value) {
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
