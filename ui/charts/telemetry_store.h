// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/messages/station_status.h"
#include "ui/charts/peak_ring.h"

#include <array>
#include <chrono>
#include <cstdint>
#include <vector>

// The data of both axes over the last half hour, for the charts: a PeakRing for each quantity of each axis. Values are
// stored in the units of the drawing. A bin is one tick at 50 Hz. Faster ticks share a bin and keep their peaks, slower
// ticks leave some bins empty. Gui thread. At most 24 MB.
namespace boresight::ui {

enum class Channel
{
    Commanded,  // degrees, axis angles: the azimuth is continuous
    Actual,
    Error,             // commanded minus actual, of the same tick
    Torque,            // Nm
    Current,           // A, q axis
    Voltage,           // V
    BoardTemperature,  // °C
    MotorTemperature
};

class TelemetryStore
{
public:
    static constexpr std::chrono::milliseconds kBin{20};
    static constexpr std::size_t kChannels = 8;

    void add(const std::vector<TickSample>& samples);

    [[nodiscard]] const PeakRing& ring(Axis axis, Channel channel) const;

    [[nodiscard]] static std::int64_t binOf(SteadyTime time);
    [[nodiscard]] static SteadyTime timeOf(std::int64_t bin);  // the time in the middle of the bin
    [[nodiscard]] static std::size_t bytes() { return 2 * kChannels * PeakRing::bytes(); }

private:
    [[nodiscard]] std::int64_t steadyBinOf(SteadyTime time) const;
    void addAxis(Axis axis, const AxisSample& sample);

    std::array<std::array<PeakRing, kChannels>, 2> m_rings;  // by Axis
    std::int64_t m_bin = 0;                                  // of the newest sample
};

}  // namespace boresight::ui
