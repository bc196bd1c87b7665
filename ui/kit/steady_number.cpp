// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/steady_number.h"

#include <cmath>

namespace boresight::ui {

namespace {

constexpr double kMostOff = 0.75;  // of the last digit

}  // namespace

SteadyNumber::SteadyNumber(int decimals, double period) : m_digit(std::pow(10.0, -decimals)), m_period(period) {}

double SteadyNumber::shown(double measured)
{
    const double away = m_shown ? measured - *m_shown : 0.0;
    const double off = std::abs(m_period > 0.0 ? std::remainder(away, m_period) : away);
    if (!m_shown || !(off <= kMostOff * m_digit)) {
        m_shown = std::round(measured / m_digit) * m_digit;
    }
    return *m_shown;
}

}  // namespace boresight::ui
