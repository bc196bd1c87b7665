// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

// The vertical scale of a strip: holds all that is shown, on round numbers, and never less than a span that has a
// meaning, so that the noise of a standing axis does not fill the strip. It grows at once and shrinks only when the
// curve has become much smaller, so that it does not dance. Pure, in the unit of the strip.
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
    [[nodiscard]] double step() const { return m_step; }  // of the labels
    [[nodiscard]] int decimals() const;                   // that tell the labels apart

private:
    void set(double least, double greatest);

    double m_leastSpan;
    ScaleForm m_form;
    double m_lower = 0.0;
    double m_upper = 0.0;
    double m_step = 1.0;
};

}  // namespace boresight::ui
