// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/telemetry_store.h"

#include "ui/kit/axes.h"

#include <cmath>

namespace boresight::ui {

namespace {

// How far a sample may be from the middle of the next bin and still count for it, in bins. Ticks come some milliseconds
// early or late. Without this tolerance one bin would be empty and another would have two samples.
constexpr double kSteady = 0.9;

double binsOf(SteadyTime time)
{
    return Seconds(time.time_since_epoch()) / Seconds(TelemetryStore::kBin);
}

}  // namespace

std::int64_t TelemetryStore::binOf(SteadyTime time)
{
    return static_cast<std::int64_t>(std::floor(binsOf(time)));
}

SteadyTime TelemetryStore::timeOf(std::int64_t bin)
{
    return SteadyTime(kBin * bin + kBin / 2);
}

std::int64_t TelemetryStore::steadyBinOf(SteadyTime time) const
{
    const double next = static_cast<double>(m_bin + 1) + 0.5;
    return std::abs(binsOf(time) - next) < kSteady ? m_bin + 1 : std::max(m_bin, binOf(time));
}

const PeakRing& TelemetryStore::ring(Axis axis, Channel channel) const
{
    return m_rings[axisIndex(axis)][static_cast<std::size_t>(channel)];
}

void TelemetryStore::add(const std::vector<TickSample>& samples)
{
    for (const TickSample& sample : samples) {
        m_bin = steadyBinOf(sample.time);
        for (const Axis axis : kAxes) {
            addAxis(axis, sample.axes[axisIndex(axis)]);
        }
    }
}

void TelemetryStore::addAxis(Axis axis, const AxisSample& sample)
{
    const auto put = [this, axis](Channel channel, const std::optional<double>& value) {
        if (value && std::isfinite(*value)) {
            m_rings[axisIndex(axis)][static_cast<std::size_t>(channel)].add(m_bin, static_cast<float>(*value));
        }
    };
    const auto degrees = [](const std::optional<Angle>& angle) {
        return angle ? std::optional(angle->degrees()) : std::nullopt;
    };
    put(Channel::Commanded, degrees(sample.commanded));
    put(Channel::Actual, degrees(sample.actual));
    if (sample.commanded && sample.actual) {
        put(Channel::Error, (*sample.commanded - *sample.actual).degrees());
    }
    put(Channel::Torque, sample.torque);
    put(Channel::Current, sample.current);
    put(Channel::Voltage, sample.busVoltage);
    put(Channel::BoardTemperature, sample.boardTemperature);
    put(Channel::MotorTemperature, sample.motorTemperature);
}

}  // namespace boresight::ui
