// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/orientation/fields.h"

#include <chrono>
#include <cmath>

namespace boresight::orientation {
namespace {

// Up to this number two decimals of a degree are exact in a double.
constexpr double kMostTurns = 1e6;

// The last time of system_clock, in the year 2262.
constexpr std::int64_t kLastMillisecond =
    std::chrono::duration_cast<std::chrono::milliseconds>(UtcTime::duration::max()).count();

Parsed<double> within(double value, double min, double max, const char* field)
{
    if (!std::isfinite(value)) {
        return refused(Refusal::NotFinite, field);
    }
    return value >= min && value <= max ? Parsed<double>(value) : refused(Refusal::OutOfRange, field);
}

}  // namespace

Parsed<Angle> azimuthOf(double degrees)
{
    return within(degrees, -360.0 * kMostTurns, 360.0 * kMostTurns, "azimuth").map(&Angle::fromDegrees);
}

Parsed<Angle> elevationOf(double degrees)
{
    return within(degrees, 0.0, 180.0, "elevation").map(&Angle::fromDegrees);
}

Parsed<UtcTime> timeOf(std::int64_t milliseconds)
{
    if (milliseconds < 0 || milliseconds > kLastMillisecond) {
        return refused(Refusal::OutOfRange, "time");
    }
    return UtcTime(std::chrono::milliseconds(milliseconds));
}

// The register of the sensor is one signed byte.
Parsed<double> temperatureOf(double celsius)
{
    return within(celsius, -128.0, 127.0, "temperature");
}

Parsed<int> calibrationDigitOf(std::int64_t digit)
{
    return digit >= 0 && digit <= 3 ? Parsed<int>(static_cast<int>(digit))
                                    : refused(Refusal::OutOfRange, "calibration");
}

}  // namespace boresight::orientation
