// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

// Sine and cosine of an angle as one value. It can be turned by a small angle without calling the library again.
// Otherwise such calls would take half of the time of a propagation. Pure.
namespace boresight::orbit {

struct Turn
{
    double sin = 0.0;
    double cos = 1.0;
};

[[nodiscard]] inline Turn turnOf(double radians)
{
    return {std::sin(radians), std::cos(radians)};
}

[[nodiscard]] inline Turn sum(const Turn& a, const Turn& b)
{
    return {a.sin * b.cos + a.cos * b.sin, a.cos * b.cos - a.sin * b.sin};
}

// Uses the series up to 0.125 rad, where the first neglected terms are below 1e-17.
[[nodiscard]] inline Turn turnedBy(const Turn& from, double radians)
{
    constexpr double kSmall = 0.125;
    if (!(std::abs(radians) < kSmall)) {
        return sum(from, turnOf(radians));
    }
    const double square = radians * radians;
    const double sine =
        radians *
        (1.0 - square * (1.0 / 6.0) *
                   (1.0 - square * (1.0 / 20.0) * (1.0 - square * (1.0 / 42.0) * (1.0 - square * (1.0 / 72.0)))));
    const double cosine =
        1.0 -
        square * 0.5 *
            (1.0 - square * (1.0 / 12.0) *
                       (1.0 - square * (1.0 / 30.0) * (1.0 - square * (1.0 / 56.0) * (1.0 - square * (1.0 / 90.0)))));
    return sum(from, {sine, cosine});
}

}  // namespace boresight::orbit
