// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/jog/jog_choices.h"

#include "ui/hold/jog_pad.h"
#include "ui/jog/rate_slider.h"
#include "ui/kit/caption.h"
#include "ui/kit/choice_button.h"
#include "ui/kit/format.h"
#include "ui/kit/value_label.h"
#include "ui/look/segments.h"

#include <QButtonGroup>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <span>
#include <utility>

namespace boresight::ui {

namespace {

struct StepSize
{
    Angle angle;
    int decimals;
};

constexpr std::array kJogChoicesSteps{StepSize{0.01_deg, 2}, StepSize{0.1_deg, 1}, StepSize{1_deg, 0},
                                      StepSize{5_deg, 0}};
constexpr Angle kJogChoicesFirstStep = 0.1_deg;

QString shownRate(AngularRate rate)
{
    return rateText(rate, rate < 1_deg_s ? 2 : 1);
}

QString helpOf(const QString& size)
{
    return JogChoices::tr("One step is %1 (Ctrl + arrow)").arg(size);
}

// The mount cannot stop between two multiples of this.
Angle coarsest(const Capabilities& capabilities)
{
    Angle step;
    for (const auto& axis : capabilities.axes) {
        step = std::max(step, axis ? axis->step : Angle{});
    }
    return step;
}

}  // namespace

JogChoices::JogChoices(const ProfileDraft& draft, JogPad& pad, QWidget* parent)
    : QWidget(parent),
      m_draft(draft),
      m_pad(pad),
      m_rate(new ValueLabel(tr("Rate while held"), fonts::label(), {}, this)),
      m_slider(new RateSlider(this))
{
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(makeRate());
    column->addWidget(m_slider);
    column->addSpacing(kGrid / 2);
    column->addWidget(makeSteps());
    m_slider->setAccessibleName(tr("Jog rate"));
    connect(m_slider, &RateSlider::rateChosen, this, &JogChoices::choose);
}

QLayout* JogChoices::makeRate()
{
    auto* const row = new QHBoxLayout;
    row->addWidget(makeCaption(tr("Rate"), *m_slider));
    row->addWidget(m_rate, 1);
    m_rate->setStretching(true);
    m_rate->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    return row;
}

QWidget* JogChoices::makeSteps()
{
    auto* const box = new QWidget(this);
    auto* const grid = new QGridLayout(box);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(kGrid / 2);
    auto* const mode = new ChoiceButton(tr("Step mode"), tr("Step mode: a press moves one step only"), box);
    mode->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    connect(mode, &QToolButton::toggled, &m_pad, &JogPad::setStepMode);
    grid->addWidget(makeCaption(tr("Step"), box), 0, 0);
    grid->addWidget(mode, 0, 1);
    grid->setColumnStretch(0, 1);
    auto* const sizes = new QButtonGroup(box);
    auto* const segments = new Segments(box);
    for (const StepSize& step : kJogChoicesSteps) {
        const QString size = angleText(step.angle, step.decimals);
        auto* const button = new ChoiceButton(size, helpOf(size), segments);
        m_steps.push_back(button);
        sizes->addButton(button);
        button->setChecked(step.angle == kJogChoicesFirstStep);
        segments->add(*button);
        connect(button, &QToolButton::clicked, this, [this, step] { m_pad.setStep(step.angle); });
    }
    m_pad.setStep(kJogChoicesFirstStep);
    grid->addWidget(segments, 1, 0, 1, 2);
    return box;
}

void JogChoices::showStatus(const StationStatus& status)
{
    m_fastest = status.permissions.fastestJog;
    m_slider->setEnds(rates().slow, rates().fast);
    showRate();
    showSteps(status.capabilities);
}

// A step that the mount cannot make is not offered. If it was chosen, the smallest possible step is chosen instead.
void JogChoices::showSteps(const Capabilities& capabilities)
{
    const Angle least = coarsest(capabilities);
    bool isMade = true;
    for (std::size_t i = 0; i < m_steps.size(); ++i) {
        const StepSize& step = kJogChoicesSteps.at(i);
        const bool before = std::exchange(isMade, step.angle >= least);
        m_steps[i]->setEnabled(isMade);
        m_steps[i]->setToolTip(isMade ? helpOf(m_steps[i]->text())
                                      : tr("This rotator moves in steps of %1°.").arg(least.degrees(), 0, 'g', 3));
        if (isMade && !before && std::ranges::any_of(std::span(m_steps).first(i), &QAbstractButton::isChecked)) {
            m_steps[i]->click();
        }
    }
}

void JogChoices::choose(AngularRate rate)
{
    m_chosen = rate;
    showRate();
}

void JogChoices::showRate()
{
    const AngularRate wanted = std::clamp(m_chosen.value_or(rates().normal), rates().slow, rates().fast);
    const AngularRate rate = std::min(wanted, m_fastest);
    m_slider->setRate(wanted);
    m_slider->setEnabled(m_fastest > rates().slow);
    m_pad.setRate(wanted);
    m_rate->setValue(rate < wanted ? tr("at most %1").arg(shownRate(rate)) : shownRate(rate));
    const QString ends =
        tr("Jog rate from %1 to %2 (arrow keys, Page Up, Page Down). Shift + arrow on the pad jogs at the fast rate.")
            .arg(shownRate(rates().slow), shownRate(rates().fast));
    m_slider->setToolTip(
        rate < wanted ? tr("The rate is at most %1 until the cable wraps are known and the directions are confirmed.")
                            .arg(shownRate(rate))
                      : ends);
    m_slider->setAccessibleDescription(shownRate(rate));
}

}  // namespace boresight::ui

#include "moc_jog_choices.cpp"
