// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim_sensor/sensor_box.h"

#include <cmath>
#include <utility>

namespace boresight::sim {
namespace {

SensorFault faultOf(const SimulatedPair& pair)
{
    constexpr std::pair<FaultKind, SensorFault> kFaults[] = {{FaultKind::SensorSilence, SensorFault::Silent},
                                                             {FaultKind::SensorDead, SensorFault::Dead},
                                                             {FaultKind::SensorFrozen, SensorFault::Frozen}};
    for (const auto& [kind, fault] : kFaults) {
        if (pair.faults().isActive(kind, Axis::Azimuth, pair.now())) {
            return fault;
        }
    }
    return SensorFault::None;
}

}  // namespace

SensorBox::SensorBox(SimulatedPair& pair, const Clock& clock, SteadyTime epoch, const SensorTruth& truth)
    : m_pair(pair), m_clock(clock), m_epoch(epoch), m_sensor(truth)
{
    m_timer.setTimerType(Qt::PreciseTimer);
    m_timer.callOnTimeout(this, &SensorBox::read);
}

void SensorBox::start()
{
    m_timer.start(SimulatedSensor::kReadingPeriod);
}

void SensorBox::read()
{
    m_sensor.setFault(faultOf(m_pair));
    if (const auto message = readOn(m_pair, m_epoch, m_clock, m_sensor)) {
        Q_EMIT said(*message);
    }
}

std::optional<SensorMessage> readOn(SimulatedPair& pair, SteadyTime epoch, const Clock& clock, SimulatedSensor& sensor)
{
    const SteadyTime now = clock.now();
    pair.advanceTo(now - epoch);
    const AxisTruth azimuth = pair.truth(Axis::Azimuth);
    const AxisTruth elevation = pair.truth(Axis::Elevation);
    return sensor.read(now, clock.utc(), {.azimuth = azimuth.angle, .elevation = elevation.angle},
                       std::abs(azimuth.current) + std::abs(elevation.current));
}

}  // namespace boresight::sim

#include "moc_sensor_box.cpp"
