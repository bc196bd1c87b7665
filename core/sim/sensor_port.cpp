// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim/sensor_port.h"

#include <unistd.h>

#include <cmath>
#include <utility>

namespace boresight::sim {

Result<std::unique_ptr<SensorPort>> SensorPort::create(const QString& link, SimulatedPair& pair, const Clock& clock,
                                                       SteadyTime epoch)
{
    return PseudoTerminal::create(link).map([&](PseudoTerminal&& terminal) {
        return std::unique_ptr<SensorPort>(new SensorPort(std::move(terminal), pair, clock, epoch));
    });
}

SensorPort::SensorPort(PseudoTerminal terminal, SimulatedPair& pair, const Clock& clock, SteadyTime epoch)
    : m_terminal(std::move(terminal)), m_pair(pair), m_clock(clock), m_epoch(epoch)
{
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, &SensorPort::read);
    m_timer.start(SimulatedSensor::kReadingPeriod);
}

void SensorPort::read()
{
    const SteadyTime now = m_clock.now();
    m_pair.advanceTo(now - m_epoch);
    const AxisTruth azimuth = m_pair.truth(Axis::Azimuth);
    const AxisTruth elevation = m_pair.truth(Axis::Elevation);
    const auto message = m_sensor.read(now, m_clock.utc(), {.azimuth = azimuth.angle, .elevation = elevation.angle},
                                       std::abs(azimuth.current) + std::abs(elevation.current));
    if (message && m_terminal.hasClient()) {
        const std::string sentence = toSentence(*message);
        // What does not fit is lost, as on a line that nobody reads.
        [[maybe_unused]] const ssize_t sent = ::write(m_terminal.number(), sentence.data(), sentence.size());
    }
}

}  // namespace boresight::sim
