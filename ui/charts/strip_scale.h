// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

// The vertical scale of a strip. It includes everything that is shown, with round numbers, and has at least a
// meaningful span, so that the noise of an axis that stands still does not fill the strip. It grows at once and shrinks
// only when the curve has become much smaller, so that it does not change all the time. Pure, in the unit of the strip.
namespace boresight::ui {

enum class ScaleForm
{
    Free,
    AroundZero  // zero in the middle
};

class StripScale
{
public:
    explicit StripScale(double leastSpan, ScaleForm form = ScaleForm::Free);

    void fit(double least, double greatest);

    [[nodiscard]] double lower() const { return m_lower; }
    [[nodiscard]] double upper() const { return m_upper; }
    [[nodiscard]] double step() const { return m_step; }  // between two labels
    [[nodiscard]] int decimals() const;                   // enough to distinguish the labels

private:
    void set(double least, double greatest);

    double m_leastSpan;
    ScaleForm m_form;
    double m_lower = 0.0;
    double m_upper = 0.0;
    double m_step = 1.0;
};

}  // namespace boresight::ui
