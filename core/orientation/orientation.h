// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/units/quantity.h"

#include <compare>
#include <cstdint>
#include <optional>
#include <string>

// One value of the orientation sensor on the mast, from a serial port (NMEA sentences) or an MQTT broker (JSON
// messages). Everything is as the sensor sent it, without mounting offset, change of sign or local declination. Plain
// values.
namespace boresight::orientation {

// The direction that the sensor reports, 0…360°. It is neither a true direction nor the angle of an axis. The
// difference is the sensor's mounting, the declination and the deviation of its compass (Correction).
class SensorHeading
{
public:
    constexpr SensorHeading() = default;
    // From the extended angle that the sensor sends: 725.40° is a heading of 5.40°, -12.67° is 347.33°.
    [[nodiscard]] static SensorHeading folded(Angle extended) { return SensorHeading(extended.wrapped360()); }

    [[nodiscard]] constexpr Angle angle() const { return m_angle; }
    // The shorter way from `other` to this heading, -180…180°.
    [[nodiscard]] Angle since(SensorHeading other) const { return (m_angle - other.m_angle).wrapped180(); }

    constexpr auto operator<=>(const SensorHeading&) const = default;

private:
    constexpr explicit SensorHeading(Angle angle) : m_angle(angle) {}

    Angle m_angle;
};

// The calibration level of each part of the sensor: 0 (not calibrated) to 3 (fully). A level may drop again.
struct Calibration
{
    int system = 0;  // 0: the heading is not related to magnetic north yet
    int gyro = 0;
    int accelerometer = 0;
    int magnetometer = 0;

    bool operator==(const Calibration&) const = default;
};

enum class Transport
{
    Serial,
    Mqtt,
    Simulated
};

struct Orientation
{
    SensorHeading heading;
    Angle extendedAzimuth;         // as sent: heading + 360° x revolutions
    std::int64_t revolutions = 0;  // as sent: from 0 or -1 after each reset of the sensor, so only a hint
    // As sent: 0…180°, the angle between the sensor's z axis and the vertical. May be negative after asMounted().
    Angle elevation;
    std::optional<double> temperature;  // °C, of the sensor's chip
    std::optional<Calibration> calibration;
    // When the sensor began to measure, by its own clock. It is sometimes a second off, so use it only for logs.
    UtcTime sensorTime;
    SteadyTime arrival;
    Transport transport = Transport::Serial;
    std::string unknown;  // unknown parts of the message, for the log; usually empty

    bool operator==(const Orientation&) const = default;
};

}  // namespace boresight::orientation
