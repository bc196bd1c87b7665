// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim/simulated_sensor.h"

#include <cmath>

namespace boresight::sim {
namespace {

// The firmware prints two decimals.
double rounded(double degrees)
{
    return std::round(degrees * 100.0) / 100.0;
}

SkyPointing beamAt(const SensorTruth& truth, const AxisPosition& axes)
{
    return pointing::PointingModel(truth.mount).toSky(axes);
}

}  // namespace

SensorTruth truthToBeFound()
{
    return {.mount = {.azimuthOffset = 37.4_deg, .tiltNorth = 0.4_deg, .tiltEast = -0.45_deg, .collimation = 0.3_deg},
            .a1 = 6.4_deg,
            .b1 = -4.8_deg,
            .a2 = 1.8_deg,
            .b2 = 2.4_deg,
            .noise = 0.5_deg};
}

void SimulatedSensor::restart()
{
    m_before = 0.0;
    m_revolutions = 0;
    m_readings = 0;
    m_last.reset();
    m_due.clear();
}

// The heading that the firmware computes from one quaternion.
Angle SimulatedSensor::headingAt(const SkyPointing& beam) const
{
    const double psi = beam.azimuth.radians();
    const Angle deviation = m_truth.a1 * std::sin(psi) + m_truth.b1 * std::cos(psi) + m_truth.a2 * std::sin(2.0 * psi) +
                            m_truth.b2 * std::cos(2.0 * psi);
    const bool isBesideSteel =
        (beam.azimuth - m_truth.steelFrom).wrapped360() < (m_truth.steelTo - m_truth.steelFrom).wrapped360();
    const Angle magnetic = beam.azimuth - m_truth.mountingOffset - m_truth.declination + deviation +
                           (isBesideSteel ? m_truth.steel : Angle{});
    return (m_truth.faceDown ? -magnetic : magnetic) + m_truth.inFirmware;
}

std::optional<SensorMessage> SimulatedSensor::read(SteadyTime now, UtcTime utc, const AxisPosition& axes,
                                                   double amperes)
{
    if (m_fault == SensorFault::Silent) {
        m_readings = 0;
        m_due.clear();
        return std::nullopt;
    }
    const SkyPointing beam = beamAt(m_truth, axes);
    const Angle heading = headingAt(beam) + m_truth.perAmpere * amperes;
    if (m_readings == 0) {
        m_began = utc;
        m_first = heading;
        m_sum = {};
    }
    m_sum += (heading - m_first).wrapped180();
    if (++m_readings >= m_truth.readings) {
        m_due.push_back({now + std::chrono::duration_cast<SteadyTime::duration>(m_truth.delay), message(beam)});
        m_readings = 0;
    }
    return takeDue(now);
}

SensorMessage SimulatedSensor::message(const SkyPointing& beam)
{
    if (m_fault == SensorFault::Frozen && m_last) {
        m_last->time = m_began;
        return *m_last;
    }
    const bool dead = m_fault == SensorFault::Dead;
    const Angle mean = dead ? m_truth.inFirmware : m_first + m_sum / m_readings + noise();
    const double heading = mean.wrapped360().degrees();
    const std::int64_t revolutions = counted(heading);
    const Angle rise = beam.elevation - m_truth.elevationOffset + noise();
    const Angle tilt = abs(m_truth.elevationDown ? Angle::fromDegrees(180.0) - rise : rise);
    m_last = SensorMessage{.time = m_began,
                           .azimuth = rounded(heading + 360.0 * static_cast<double>(revolutions)),
                           .elevation = dead ? 0.0 : rounded(std::min(tilt.degrees(), 180.0)),
                           .revolutions = revolutions,
                           .temperature = dead ? 0 : m_truth.temperature,
                           .calibration = dead ? orientation::Calibration{} : m_truth.calibration};
    return *m_last;
}

// Counts when the sent heading passes zero. Before the first message the heading was 0.
std::int64_t SimulatedSensor::counted(double heading)
{
    if (heading - m_before < -180.0) {
        ++m_revolutions;
    } else if (heading - m_before > 180.0) {
        --m_revolutions;
    }
    m_before = heading;
    return m_revolutions;
}

Angle SimulatedSensor::noise()
{
    return m_truth.noise * m_normal(m_random);
}

std::optional<SensorMessage> SimulatedSensor::takeDue(SteadyTime now)
{
    if (m_due.empty() || m_due.front().at > now) {
        return std::nullopt;
    }
    const SensorMessage message = m_due.front().message;
    m_due.pop_front();
    return message;
}

}  // namespace boresight::sim
