// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/strip_scale.h"

#include <algorithm>
#include <cmath>

namespace boresight::ui {

namespace {

constexpr double kHeadroom = 0.05;         // as a part of the span, above and below
constexpr double kShrinkBelow = 0.35;      // a curve smaller than this part of the span is enlarged
constexpr double kStripScaleLabels = 3.0;  // approximate number of label steps in a low strip

// 1, 2 or 5 times a power of ten, at least `wanted`.
double roundStep(double wanted)
{
    const double power = std::pow(10.0, std::floor(std::log10(wanted)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * power >= wanted * (1.0 - 1e-9)) {
            return factor * power;
        }
    }
    return 10.0 * power;
}

}  // namespace

StripScale::StripScale(double leastSpan, ScaleForm form) : m_leastSpan(leastSpan), m_form(form)
{
    set(0.0, 0.0);
}

void StripScale::fit(double least, double greatest)
{
    if (m_form == ScaleForm::AroundZero) {
        greatest = std::max(std::abs(least), std::abs(greatest));
        least = -greatest;
    }
    const double span = std::max(greatest - least, m_leastSpan);
    const bool inside = least >= m_lower && greatest <= m_upper;
    if (!inside || span < kShrinkBelow * (m_upper - m_lower)) {
        set(least, greatest);
    }
}

void StripScale::set(double least, double greatest)
{
    const double middle = (least + greatest) / 2.0;
    const double half = std::max(greatest - least, m_leastSpan) * (0.5 + kHeadroom);
    m_step = roundStep(2.0 * half / kStripScaleLabels);
    // The ends may lie half a step beside the labels, because whole steps would waste a third of a low strip.
    const double grain = m_step / 2.0;
    m_lower = std::floor((middle - half) / grain) * grain;
    m_upper = std::ceil((middle + half) / grain) * grain;
}

int StripScale::decimals() const
{
    return std::max(0, static_cast<int>(std::ceil(-std::log10(m_step) - 1e-9)));
}

}  // namespace boresight::ui
