// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geomagnetism/legendre.h"

#include <cmath>

namespace boresight::geomagnetism {

namespace {

double root(int n, int m)
{
    return std::sqrt(static_cast<double>(n * n - m * m));
}

}  // namespace

// Starts from the diagonal of each m. Division by sin θ changes only the values at the diagonals.
Legendre::Legendre(double cosine, double sine) : m_cosine(cosine), m_sine(sine)
{
    for (int m = 0; m <= kDegree; ++m) {
        m_reduced[termIndex(m, m)] =
            m < 2 ? 1.0 : sine * std::sqrt((2.0 * m - 1.0) / (2.0 * m)) * reduced(m - 1, m - 1);
        for (int n = m + 1; n <= kDegree; ++n) {
            m_reduced[termIndex(n, m)] =
                ((2.0 * n - 1.0) * cosine * reduced(n - 1, m) - root(n - 1, m) * reduced(n - 2, m)) / root(n, m);
        }
    }
}

double Legendre::reduced(int n, int m) const
{
    return n < m ? 0.0 : m_reduced[termIndex(n, m)];
}

double Legendre::value(int n, int m) const
{
    return m > 0 ? m_sine * reduced(n, m) : reduced(n, 0);
}

double Legendre::overSine(int n, int m) const
{
    return reduced(n, m);
}

double Legendre::slope(int n, int m) const
{
    return m > 0 ? n * m_cosine * reduced(n, m) - root(n, m) * reduced(n - 1, m)
                 : -std::sqrt(n * (n + 1.0) / 2.0) * value(n, 1);
}

}  // namespace boresight::geomagnetism
