// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

// Three coordinates: kilometres or kilometres per second. Pure value.
namespace boresight::orbit {

struct Vector
{
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;

    bool operator==(const Vector&) const = default;
    friend Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend Vector operator*(double factor, const Vector& a) { return {factor * a.x, factor * a.y, factor * a.z}; }
};

[[nodiscard]] inline double dot(const Vector& a, const Vector& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

[[nodiscard]] inline double length(const Vector& a)
{
    return std::sqrt(dot(a, a));
}

}  // namespace boresight::orbit
