// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/jog/jog_choices.h"

#include "ui/hold/jog_pad.h"
#include "ui/jog/rate_slider.h"
#include "ui/kit/caption.h"
#include "ui/kit/choice_button.h"
#include "ui/kit/format.h"
#include "ui/kit/value_label.h"

#include <QButtonGroup>
#include <QVBoxLayout>

#include <algorithm>

namespace boresight::ui {

namespace {

struct StepSize
{
    Angle angle;
    int decimals;
};

constexpr StepSize kJogChoicesSteps[] = {{0.01_deg, 2}, {0.1_deg, 1}, {1_deg, 0}, {5_deg, 0}};
constexpr Angle kJogChoicesFirstStep = 0.1_deg;

QString shownRate(AngularRate rate)
{
    return rateText(rate, rate < 1_deg_s ? 2 : 1);
}

}  // namespace

JogChoices::JogChoices(JogPad& pad, QWidget* parent)
    : QWidget(parent),
      m_pad(pad),
      m_caption(new ValueLabel(tr("Rate while held"), fonts::label(), {}, this)),
      m_slider(new RateSlider(this))
{
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    column->addWidget(m_caption);
    column->addWidget(m_slider);
    column->addWidget(makeSteps());
    column->addStretch(1);
    m_caption->setStretching(true);
    m_slider->setAccessibleName(tr("Jog rate"));
    connect(m_slider, &RateSlider::rateChosen, this, &JogChoices::choose);
}

QWidget* JogChoices::makeSteps()
{
    auto* const box = new QWidget(this);
    auto* const grid = new QGridLayout(box);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(4);
    grid->addWidget(makeCaption(tr("Step"), box), 0, 0, 1, 4);
    auto* const sizes = new QButtonGroup(box);
    int column = 0;
    for (const StepSize& step : kJogChoicesSteps) {
        const QString size = angleText(step.angle, step.decimals);
        auto* const button = new ChoiceButton(size, tr("One step is %1 (Ctrl + arrow)").arg(size), box);
        sizes->addButton(button);
        button->setChecked(step.angle == kJogChoicesFirstStep);
        grid->addWidget(button, 1, column++);
        connect(button, &QToolButton::clicked, this, [this, step] { m_pad.setStep(step.angle); });
    }
    m_pad.setStep(kJogChoicesFirstStep);
    auto* const mode = new ChoiceButton(tr("Step mode"), tr("Step mode: a press moves one step only"), box);
    grid->addWidget(mode, 2, 0, 1, 4);
    connect(mode, &QToolButton::toggled, &m_pad, &JogPad::setStepMode);
    return box;
}

void JogChoices::showStatus(const StationStatus& status)
{
    const AngularRate fastest = status.permissions.fastestJog;
    const bool same = status.profile->jog == rates() && fastest == m_fastest;
    m_profile = status.profile;
    if (same) {
        return;
    }
    m_fastest = fastest;
    m_slider->setEnds(rates().slow, rates().fast);
    showRate();
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
    m_caption->setValue(rate < wanted ? tr("Rate at most %1").arg(shownRate(rate))
                                      : tr("Rate while held  %1").arg(shownRate(rate)));
    const QString ends =
        tr("Jog rate from %1 to %2 (arrows, Page Up, Page Down; Shift + arrow on the pad: the fastest)")
            .arg(shownRate(rates().slow), shownRate(rates().fast));
    m_slider->setToolTip(
        rate < wanted
            ? tr("At most %1 until it is known where the axes stand and which way they turn").arg(shownRate(rate))
            : ends);
    m_slider->setAccessibleDescription(shownRate(rate));
}

}  // namespace boresight::ui

#include "moc_jog_choices.cpp"
