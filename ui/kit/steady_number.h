// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

// The value to show for a measured number with fixed decimals, so that noise does not change the last digit all the
// time. A number on the border between two digits would alternate between them, near north even between 0.00° and
// 359.99°. The shown number changes when it differs from the measured one by three quarters of the last digit, so its
// error is never larger. Plain rounding has an error of up to one half. Pure, one thread.
namespace boresight::ui {

class SteadyNumber
{
public:
    // Numbers that differ by the period are equal. 0: the number has no period.
    explicit SteadyNumber(int decimals, double period = 0.0);

    // The measured number, rounded.
    [[nodiscard]] double shown(double measured);

private:
    const double m_digit;  // the value of the last digit
    const double m_period;
    std::optional<double> m_shown;
};

}  // namespace boresight::ui
