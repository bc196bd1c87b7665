// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recording/recording.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

// A recorded pass for tests: 50 Hz, both axes of a mount with drives that report everything, and noise like that of
// real sensors.
namespace boresight::recording {

inline constexpr UtcTime kRecordedFrom{std::chrono::milliseconds(1'795'000'000'000)};

inline Header recordedHeader()
{
    return {
        .program = QStringLiteral("Boresight 0.1.0"),
        .mount = QStringLiteral("Roof"),
        .site =
            Site{.latitude = Angle::fromDegrees(38.75), .longitude = Angle::fromDegrees(-9.125), .heightMetres = 100.0},
        .beamWidth = Angle::fromDegrees(2.5),
        .target = QStringLiteral("NOAA 19"),
        .number = 33591,
        .client = QStringLiteral("rotctld 127.0.0.1:51234"),
        .began = kRecordedFrom,
        .part = 1,
        .stateWords = {QStringLiteral("HOLD"), QStringLiteral("SLEW"), QStringLiteral("TRACK")},
        .axisWords = {QStringLiteral("NO DATA"), QStringLiteral("HOLDING"), QStringLiteral("MOVING")}};
}

class RecordedPass
{
public:
    // Tick after tick. The values have the resolution of the file, so that a test can compare them.
    [[nodiscard]] Tick next()
    {
        const double t = 0.02 * static_cast<double>(m_count);
        Tick tick{.utc = kRecordedFrom + std::chrono::milliseconds(20) * static_cast<int>(m_count) +
                         std::chrono::microseconds(100) * std::lround(noise(3.0)),
                  .state = t < 3.0 ? 1 : 2};
        const double azimuth = 180.0 + 2.0 * std::atan((t - 300.0) / 40.0) * 57.3 * 0.5;
        const double elevation = 80.0 / (1.0 + (t - 300.0) * (t - 300.0) / 14'400.0);
        const double rate = 57.3 / 40.0 / (1.0 + (t - 300.0) * (t - 300.0) / 1'600.0);
        const double climb = -160.0 * (t - 300.0) / 14'400.0 / std::pow(1.0 + (t - 300.0) * (t - 300.0) / 14'400.0, 2);
        tick.axes[0] = axisAt(azimuth, rate);
        tick.axes[1] = axisAt(elevation, climb);
        tick.target = SkyPointing{angle(azimuth, 1e4), angle(elevation, 1e4)};
        tick.commanded = SkyPointing{angle(azimuth + 0.0011, 1e4), angle(elevation - 0.0007, 1e4)};
        tick.actual = SkyPointing{*tick.axes[0].actual, *tick.axes[1].actual};
        tick.error = angle(0.01 + std::abs(noise(0.008)), 1e4);
        if (m_count % 5 == 0) {  // a sensor with 10 readings in a second
            m_sensor = SkyPointing{angle(azimuth + noise(0.5), 100.0), angle(elevation + noise(0.2), 100.0)};
        }
        if (m_count % 50 == 0) {
            m_wind = rounded(6.0 + noise(1.5), 100.0);
        }
        tick.sensor = m_sensor;
        tick.wind = m_wind;
        ++m_count;
        return tick;
    }

    [[nodiscard]] std::vector<Tick> ticks(std::size_t count)
    {
        std::vector<Tick> all(count);
        std::ranges::generate(all, [this] { return next(); });
        return all;
    }

private:
    [[nodiscard]] double noise(double sigma) { return std::normal_distribution(0.0, sigma)(m_random); }
    // As the reader computes it.
    [[nodiscard]] static double rounded(double value, double perUnit)
    {
        return static_cast<double>(std::llround(value * perUnit)) / perUnit;
    }
    [[nodiscard]] static Angle angle(double degrees, double perUnit)
    {
        return Angle::fromDegrees(rounded(degrees, perUnit));
    }

    [[nodiscard]] AxisTick axisAt(double degrees, double rate)
    {
        return {.actual = angle(degrees + noise(0.006), 1e4),
                .commanded = angle(degrees + 0.0011, 1e4),
                .target = angle(degrees, 1e4),
                .rate = AngularRate::fromDegrees(rounded(rate + noise(0.08), 1e3)),
                .commandedRate = AngularRate::fromDegrees(rounded(rate, 1e3)),
                .torque = rounded(0.4 + 0.1 * rate + noise(0.06), 1e3),
                .current = rounded(1.2 + 0.3 * rate + noise(0.1), 1e3),
                .busVoltage = rounded(24.1 + noise(0.05), 100.0),
                .power = rounded(9.0 + rate + noise(1.5), 10.0),
                .boardTemperature = rounded(31.5 + noise(0.1), 10.0),
                .motorTemperature = rounded(28.0 + noise(0.1), 10.0),
                .state = 2};
    }

    std::mt19937 m_random{17};
    std::size_t m_count = 0;
    std::optional<SkyPointing> m_sensor;
    std::optional<double> m_wind;
};

}  // namespace boresight::recording
