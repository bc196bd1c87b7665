// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

// What to show of a measured number with fixed decimals, so that its noise does not flip the last digit. A number on
// the border between two digits would show one after the other, and near north 0.00° after 359.99°. The shown number
// changes once it is three quarters of the last digit away from the measured one, so it is never wrong by more. Plain
// rounding is wrong by up to one half. Pure, one thread.
namespace boresight::ui {

class SteadyNumber
{
public:
    // Numbers that differ by the period are the same; 0: the number has none.
    explicit SteadyNumber(int decimals, double period = 0.0);

    // The measured number, rounded.
    [[nodiscard]] double shown(double measured);

private:
    const double m_digit;  // the last one, as a number
    const double m_period;
    std::optional<double> m_shown;
};

}  // namespace boresight::ui
