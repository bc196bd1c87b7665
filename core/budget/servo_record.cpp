// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/budget/servo_record.h"

#include <algorithm>
#include <cmath>

namespace boresight::budget {

void ServoRecord::add(SteadyTime time, Angle error)
{
    while (!m_window.empty() && time - m_window.front().time > kWindow) {
        m_window.pop_front();
    }
    m_window.push_back({.time = time, .error = error});
}

std::optional<ServoRecord::Summary> ServoRecord::summary(SteadyTime now) const
{
    if (m_window.empty() || now - m_window.back().time > kOldAfter) {
        return std::nullopt;
    }
    double squares = 0.0;
    int count = 0;
    Angle peak;
    for (const Measured& one : m_window) {
        if (now - one.time <= kWindow) {
            squares += one.error.radians() * one.error.radians();
            ++count;
            peak = std::max(peak, abs(one.error));
        }
    }
    return Summary{.now = m_window.back().error, .rms = Angle::fromRadians(std::sqrt(squares / count)), .peak = peak};
}

}  // namespace boresight::budget
