// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/guide/guide_ready.h"

#include "ui/clients/gpredict_settings.h"
#include "ui/guide/step_button.h"
#include "ui/guide/step_mark.h"
#include "ui/kit/axes.h"
#include "ui/kit/command_button.h"
#include "ui/kit/format.h"
#include "ui/kit/push_button.h"
#include "ui/kit/value_label.h"

#include <QApplication>
#include <QClipboard>
#include <QGridLayout>
#include <QVBoxLayout>

namespace boresight::ui {

namespace {

struct StepCount
{
    int done = 0;
    int skipped = 0;
    int open = 0;
    int needYou = 0;
};

QString summaryOf(const StepCount& count)
{
    if (count.needYou > 0) {
        return count.needYou == 1 ? GuideReady::tr("Not ready: one step needs you.")
                                  : GuideReady::tr("Not ready: %1 steps need you.").arg(count.needYou);
    }
    const int left = count.skipped + count.open;
    return left == 0 ? GuideReady::tr("Every step is done.")
                     : GuideReady::tr("Done: %1. Skipped: %2. To do: %3. Press a step to go back to it.")
                           .arg(count.done)
                           .arg(count.skipped)
                           .arg(count.open);
}

void addTo(StepCount& count, StepState state)
{
    switch (state) {
        case StepState::Done:
            ++count.done;
            break;
        case StepState::Skipped:
            ++count.skipped;
            break;
        case StepState::NeedsYou:
            ++count.needYou;
            break;
        case StepState::Open:
            ++count.open;
            break;
    }
}

QString parkText(const StationStatus& status)
{
    const AxisPosition& park = status.profile->park;
    const auto missing = missingAxis(status);
    return !missing                      ? axisText(park)
           : *missing == Axis::Elevation ? GuideReady::tr("azimuth %1").arg(angleText(park.azimuth, 1))
                                         : GuideReady::tr("elevation %1").arg(angleText(park.elevation, 1));
}

QString endOfPass(const StationStatus& status)
{
    return GuideReady::tr(
               "After the pass, Park (Ctrl+P) moves the mount to %1. To stop it at any time, press STOP, Pause or F12. "
               "The mast also needs a hard-wired emergency stop.")
        .arg(parkText(status));
}

}  // namespace

GuideReady::GuideReady(QWidget* parent)
    : QWidget(parent),
      m_summary(new ValueLabel(tr("What is done"), fonts::label(), {}, this)),
      m_inTheWay(new ValueLabel(tr("Why the mount cannot point now"), fonts::label(), {}, this)),
      m_client(new ValueLabel(tr("Line for Gpredict"), fonts::label(), {}, this)),
      m_pass(new ValueLabel(tr("What to do for the first pass"), fonts::label(), {}, this)),
      m_end(new ValueLabel(tr("After the pass"), fonts::label(), {}, this)),
      m_copy(nullptr),
      m_grid(new QGridLayout)
{
    for (const GuideStep step : kWorkSteps) {
        auto* const button = new StepButton(step, StepButton::Form::Line, this);
        m_steps[step] = button;
        connect(button, &QAbstractButton::clicked, this, [this, step] { Q_EMIT stepWanted(step); });
    }
    m_copy = makePushButton({.text = tr("Copy"),
                             .name = tr("Copy the line for Gpredict"),
                             .help = tr("Put the settings for Gpredict into the clipboard")},
                            this);
    build();
    connect(m_copy, &QPushButton::clicked, this, &GuideReady::copy);
}

void GuideReady::build()
{
    for (ValueLabel* const label : {m_summary, m_inTheWay, m_client, m_pass, m_end}) {
        label->setStretching(true);
        label->setLines(2);
    }
    m_inTheWay->setCollapsing(true);
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(2);
    m_grid->setSpacing(2);
    auto* const line = new QHBoxLayout;
    line->setSpacing(4);
    line->addWidget(m_client, 1);
    line->addWidget(m_copy);
    column->addWidget(m_summary);
    column->addLayout(m_grid);
    column->addWidget(m_inTheWay);
    column->addLayout(line);
    column->addWidget(m_pass);
    column->addWidget(m_end);
    column->addStretch(1);
}

void GuideReady::showStatus(const StationStatus& status, const GuideProgress& progress)
{
    showSteps(status, progress);
    showFirstPass(status);
}

// Puts the steps of this mount into two columns without a gap.
void GuideReady::place(const std::vector<StepButton*>& buttons)
{
    if (buttons == m_placed) {
        return;
    }
    m_placed = buttons;
    const int rows = static_cast<int>(buttons.size() + 1) / 2;
    int at = 0;
    for (StepButton* const button : buttons) {
        m_grid->removeWidget(button);
        m_grid->addWidget(button, at % rows, at / rows);
        ++at;
    }
}

void GuideReady::showSteps(const StationStatus& status, const GuideProgress& progress)
{
    StepCount count;
    std::vector<StepButton*> mine;
    for (const auto& [step, button] : m_steps) {
        button->setNumber(numberOf(step, status));
        button->setVisible(applies(step, status));
        if (applies(step, status)) {
            const StepReport report = reportOf(step, status, progress);
            button->showReport(report);
            addTo(count, report.state);
            mine.push_back(button);
        }
    }
    place(mine);
    const QString summary = summaryOf(count);
    const QString simulated = tr("%1 This is the simulated mount. A real mount starts at step 1.").arg(summary);
    m_summary->setValue(status.simulated ? simulated : summary, count.needYou > 0 ? Tone::Warning : Tone::Normal,
                        count.needYou > 0 ? Symbol::Warning : Symbol::None);
}

void GuideReady::showFirstPass(const StationStatus& status)
{
    const QString obstacle = status.permissions.reason(Action::Point);
    m_inTheWay->setValue(obstacle.isEmpty() ? QString() : tr("Not yet: %1").arg(obstacle), Tone::Warning,
                         obstacle.isEmpty() ? Symbol::None : Symbol::Warning);
    m_gpredict = status.listening.isEmpty() ? QString() : gpredictSettings(status);
    m_copy->setEnabled(!m_gpredict.isEmpty());
    m_client->setValue(gpredictInBrief(status), status.listening.isEmpty() ? Tone::Warning : Tone::Normal,
                       status.listening.isEmpty() ? Symbol::Warning : Symbol::None);
    m_pass->setValue(tr(
        "Open Antenna Control in Gpredict. Choose the satellite. Press Track, then Engage. The state becomes TRACK."));
    m_end->setValue(endOfPass(status));
}

void GuideReady::copy()
{
    QApplication::clipboard()->setText(m_gpredict);
}

}  // namespace boresight::ui

#include "moc_guide_ready.cpp"
