// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus/scaling.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace boresight::moteus {
namespace {

using Steps = std::array<double, 3>;  // i8, i16, i32

// Steps of the register map, in the order of Kind up to Fraction.
constexpr std::array<Steps, 10> kSteps{{
    {0.01, 0.0001, 0.00001},                          // Position, rev
    {0.1, 0.00025, 0.00001},                          // Velocity, rev/s
    {0.05, 0.001, 0.00001},                           // Acceleration, rev/s²
    {0.5, 0.01, 0.001},                               // Torque, Nm
    {1.0, 0.1, 0.001},                                // Current, A
    {1.0, 0.1, 0.001},                                // Temperature, °C
    {0.5, 0.1, 0.001},                                // Voltage, V
    {10.0, 0.05, 0.0001},                             // Power, W
    {0.01, 0.001, 0.000001},                          // Time, s
    {1.0 / 127.0, 1.0 / 32767.0, 1.0 / 2147483647.0}  // Fraction
}};

// A float holds integers exactly up to 2^24. The drive sends its counter modulo 2^23.
constexpr double kCounterFloatModulus = 8388608.0;

bool isScaled(Kind kind)
{
    return kind <= Kind::Fraction;
}

std::int64_t largest(Resolution resolution)
{
    static constexpr std::array<std::int64_t, 3> kLargest{std::numeric_limits<std::int8_t>::max(),
                                                          std::numeric_limits<std::int16_t>::max(),
                                                          std::numeric_limits<std::int32_t>::max()};
    return kLargest[static_cast<std::size_t>(resolution)];
}

std::uint32_t floatBits(double value, Kind kind, Side side)
{
    if (kind == Kind::Counter && side == Side::Device && std::isfinite(value)) {
        value = std::fmod(value, kCounterFloatModulus);
    }
    return std::bit_cast<std::uint32_t>(static_cast<float>(value));
}

std::int64_t saturated(double steps, std::int64_t limit)
{
    return static_cast<std::int64_t>(std::clamp(steps, -static_cast<double>(limit), static_cast<double>(limit)));
}

std::int64_t countSteps(double value, Kind kind, Resolution resolution, Side side)
{
    const std::int64_t limit = largest(resolution);
    if (!std::isfinite(value)) {
        return -limit - 1;
    }
    if (!isScaled(kind)) {
        const bool wraps = side == Side::Device || kind == Kind::Counter || kind == Kind::Identity;
        return saturated(value, wraps ? std::int64_t{1} << 52 : limit);
    }
    const double step = stepSize(kind, resolution);
    const double steps =
        side == Side::Client ? value / step : double{static_cast<float>(value) / static_cast<float>(step)};
    return saturated(steps, limit);
}

std::int32_t signExtended(std::uint32_t bits, Resolution resolution)
{
    switch (resolution) {
        case Resolution::Int8:
            return static_cast<std::int8_t>(bits);
        case Resolution::Int16:
            return static_cast<std::int16_t>(bits);
        case Resolution::Int32:
        case Resolution::Float:
            break;
    }
    return static_cast<std::int32_t>(bits);
}

}  // namespace

double stepSize(Kind kind, Resolution resolution)
{
    if (!isScaled(kind) || resolution == Resolution::Float) {
        return 1.0;
    }
    return kSteps[static_cast<std::size_t>(kind)][static_cast<std::size_t>(resolution)];
}

std::uint32_t toWire(double value, Kind kind, Resolution resolution, Side side)
{
    if (resolution == Resolution::Float) {
        return floatBits(value, kind, side);
    }
    return static_cast<std::uint32_t>(countSteps(value, kind, resolution, side));
}

double fromWire(std::uint32_t bits, Kind kind, Resolution resolution, Side side)
{
    if (resolution == Resolution::Float) {
        return double{std::bit_cast<float>(bits)};
    }
    const std::int32_t steps = signExtended(bits, resolution);
    if (!isScaled(kind)) {
        return steps;
    }
    if (steps == -largest(resolution) - 1) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    const double step = stepSize(kind, resolution);
    return side == Side::Client ? steps * step : double{static_cast<float>(steps) * static_cast<float>(step)};
}

}  // namespace boresight::moteus
