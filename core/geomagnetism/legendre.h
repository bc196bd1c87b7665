// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geomagnetism/coefficients.h"

// Schmidt's half-normalised associated Legendre functions P(n, m) of the cosine of the colatitude θ, with their slopes.
// For m > 0 they are stored divided by sin θ. So nothing is divided by zero at the poles. Pure.
namespace boresight::geomagnetism {

class Legendre
{
public:
    Legendre(double cosine, double sine);

    [[nodiscard]] double value(int n, int m) const;
    [[nodiscard]] double overSine(int n, int m) const;  // P / sin θ, for m > 0
    [[nodiscard]] double slope(int n, int m) const;     // dP / dθ

private:
    [[nodiscard]] double reduced(int n, int m) const;

    double m_cosine;
    double m_sine;
    std::array<double, termIndex(kDegree, kDegree) + 1> m_reduced{};
};

}  // namespace boresight::geomagnetism
