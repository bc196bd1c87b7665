// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"

#include <cmath>
#include <compare>
#include <concepts>
#include <numbers>

// Strong types for angles and motor turns and their time derivatives. Each holds one double: radians for the sky and
// the axes, turns for the drive. There is no implicit conversion from or to double, and the two kinds never mix. Only
// MountModel converts between them.
namespace boresight {

struct AngleKind;  // radians
struct MotorKind;  // turns (revolutions) in the drive's own frame

template <class Kind, int PerSecond>
class Quantity
{
public:
    constexpr Quantity() = default;

    static constexpr Quantity fromRadians(double value) requires std::same_as<Kind, AngleKind>
    {
        return Quantity(value);
    }
    static constexpr Quantity fromDegrees(double value) requires std::same_as<Kind, AngleKind>
    {
        return Quantity(value * (std::numbers::pi / 180.0));
    }
    static constexpr Quantity fromTurns(double value)
    {
        if constexpr (std::same_as<Kind, AngleKind>) {
            return Quantity(value * (2.0 * std::numbers::pi));
        } else {
            return Quantity(value);
        }
    }

    [[nodiscard]] constexpr double radians() const requires std::same_as<Kind, AngleKind> { return m_value; }
    [[nodiscard]] constexpr double degrees() const requires std::same_as<Kind, AngleKind>
    {
        return m_value * (180.0 / std::numbers::pi);
    }
    [[nodiscard]] constexpr double turns() const
    {
        if constexpr (std::same_as<Kind, AngleKind>) {
            return m_value / (2.0 * std::numbers::pi);
        } else {
            return m_value;
        }
    }
    [[nodiscard]] bool isFinite() const { return std::isfinite(m_value); }

    constexpr auto operator<=>(const Quantity&) const = default;
    constexpr Quantity operator-() const { return Quantity(-m_value); }
    constexpr Quantity& operator+=(Quantity other)
    {
        m_value += other.m_value;
        return *this;
    }
    constexpr Quantity& operator-=(Quantity other)
    {
        m_value -= other.m_value;
        return *this;
    }
    friend constexpr Quantity operator+(Quantity a, Quantity b) { return Quantity(a.m_value + b.m_value); }
    friend constexpr Quantity operator-(Quantity a, Quantity b) { return Quantity(a.m_value - b.m_value); }
    friend constexpr Quantity operator*(Quantity a, double factor) { return Quantity(a.m_value * factor); }
    friend constexpr Quantity operator*(double factor, Quantity a) { return Quantity(a.m_value * factor); }
    friend constexpr Quantity operator/(Quantity a, double divisor) { return Quantity(a.m_value / divisor); }
    friend constexpr double operator/(Quantity a, Quantity b) { return a.m_value / b.m_value; }

    // Division by time and its inverse: Angle / Seconds is an AngularRate, AngularRate * Seconds is an Angle.
    friend constexpr Quantity<Kind, PerSecond + 1> operator/(Quantity a, Seconds time)
    {
        return Quantity<Kind, PerSecond + 1>(a.m_value / time.count());
    }
    friend constexpr auto operator*(Quantity a, Seconds time) requires(PerSecond > 0)
    {
        return Quantity<Kind, PerSecond - 1>(a.m_value * time.count());
    }

    // The same direction in [0°, 360°), in [-180°, 180°), or on the turn nearest to a reference.
    [[nodiscard]] Quantity wrapped360() const requires(std::same_as<Kind, AngleKind>&& PerSecond == 0)
    {
        const double full = 2.0 * std::numbers::pi;
        const double rest = m_value - full * std::floor(m_value / full);
        return Quantity(rest < full ? rest : 0.0);  // rounding makes a full turn of a tiny negative angle
    }
    [[nodiscard]] Quantity wrapped180() const requires(std::same_as<Kind, AngleKind>&& PerSecond == 0)
    {
        return Quantity((*this + fromRadians(std::numbers::pi)).wrapped360().m_value - std::numbers::pi);
    }
    [[nodiscard]] Quantity nearestTo(Quantity reference) const requires(std::same_as<Kind, AngleKind>&& PerSecond == 0)
    {
        return reference + (*this - reference).wrapped180();
    }

private:
    template <class, int>
    friend class Quantity;
    constexpr explicit Quantity(double value) : m_value(value) {}

    double m_value = 0.0;
};

using Angle = Quantity<AngleKind, 0>;
using AngularRate = Quantity<AngleKind, 1>;
using AngularAcceleration = Quantity<AngleKind, 2>;
using AngularJerk = Quantity<AngleKind, 3>;

using MotorTurns = Quantity<MotorKind, 0>;
using MotorRate = Quantity<MotorKind, 1>;
using MotorAcceleration = Quantity<MotorKind, 2>;

template <class Kind, int PerSecond>
[[nodiscard]] Quantity<Kind, PerSecond> abs(Quantity<Kind, PerSecond> value)
{
    return value < Quantity<Kind, PerSecond>{} ? -value : value;
}

inline namespace literals {
constexpr Angle operator""_deg(long double value)
{
    return Angle::fromDegrees(static_cast<double>(value));
}
constexpr Angle operator""_deg(unsigned long long value)
{
    return Angle::fromDegrees(static_cast<double>(value));
}
constexpr AngularRate operator""_deg_s(long double value)
{
    return AngularRate::fromDegrees(static_cast<double>(value));
}
constexpr AngularRate operator""_deg_s(unsigned long long value)
{
    return AngularRate::fromDegrees(static_cast<double>(value));
}
constexpr AngularAcceleration operator""_deg_s2(long double value)
{
    return AngularAcceleration::fromDegrees(static_cast<double>(value));
}
constexpr AngularAcceleration operator""_deg_s2(unsigned long long value)
{
    return AngularAcceleration::fromDegrees(static_cast<double>(value));
}
}  // namespace literals

}  // namespace boresight
