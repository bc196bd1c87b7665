// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "core/units/quantity.h"

#include <algorithm>
#include <cmath>
#include <optional>

// Records one axis tick by tick: the largest speed and acceleration of its set-points by finite differences, the error
// of the true antenna from the set-points, and how far it turned in all and backwards.
namespace boresight::system_test {

class AxisWatch
{
public:
    void look(Angle commanded, Angle actual, Seconds tick)
    {
        if (m_commanded) {
            const AngularRate rate = (commanded - *m_commanded) / tick;
            m_fastest = std::max(m_fastest, abs(rate));
            if (m_rate) {
                m_hardest = std::max(m_hardest, abs((rate - *m_rate) / tick));
            }
            m_rate = rate;
            m_turned += abs(actual - *m_actual);
        }
        m_commanded = commanded;
        m_actual = actual;
        m_lowest = std::min(m_lowest.value_or(actual), actual);
        m_highest = std::max(m_highest.value_or(actual), actual);
        const double error = (actual - commanded).degrees();
        m_worst = std::max(m_worst, std::abs(error));
        m_squares += error * error;
        ++m_count;
    }

    [[nodiscard]] double fastest() const { return m_fastest.degrees(); }  // °/s
    [[nodiscard]] double hardest() const { return m_hardest.degrees(); }  // °/s²
    [[nodiscard]] double worst() const { return m_worst; }                // °, the largest error
    [[nodiscard]] double rms() const { return std::sqrt(m_squares / std::max(m_count, 1)); }
    [[nodiscard]] double turned() const { return m_turned.degrees(); }
    [[nodiscard]] double lowest() const { return m_lowest->degrees(); }
    [[nodiscard]] double highest() const { return m_highest->degrees(); }

private:
    std::optional<Angle> m_commanded;
    std::optional<Angle> m_actual;
    std::optional<AngularRate> m_rate;
    std::optional<Angle> m_lowest;
    std::optional<Angle> m_highest;
    AngularRate m_fastest;
    AngularAcceleration m_hardest;
    Angle m_turned;
    double m_worst = 0.0;
    double m_squares = 0.0;
    int m_count = 0;
};

// The angle between two directions.
[[nodiscard]] inline Angle separation(const SkyPointing& one, const SkyPointing& other)
{
    const auto haversine = [](Angle angle) {
        const double half = std::sin(angle.radians() / 2.0);
        return half * half;
    };
    const double squared = haversine(one.elevation - other.elevation) + std::cos(one.elevation.radians()) *
                                                                            std::cos(other.elevation.radians()) *
                                                                            haversine(one.azimuth - other.azimuth);
    return Angle::fromRadians(2.0 * std::asin(std::min(std::sqrt(squared), 1.0)));
}

}  // namespace boresight::system_test
