// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tuning/measure_page.h"

#include "ui/kit/axes.h"
#include "ui/kit/choice_button.h"
#include "ui/kit/command_button.h"
#include "ui/kit/format.h"
#include "ui/kit/read_table.h"
#include "ui/kit/value_label.h"
#include "ui/tuning/figures_model.h"
#include "ui/tuning/response_chart.h"
#include "ui/tuning/tuning_words.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QTableView>
#include <QVBoxLayout>

namespace boresight::ui {

namespace {

QString runHelp(TuningRun run)
{
    switch (run) {
        case TuningRun::Step:
            return MeasurePage::tr("Moves 2° away and back. Shows overshoot and settling time");
        case TuningRun::Ramp:
            return MeasurePage::tr("Moves away and back at 0.5 °/s. Shows the tracking error of a pass");
        case TuningRun::Sweep:
            return MeasurePage::tr(
                "Swings a little at four frequencies. Shows the highest frequency that the axis follows");
        case TuningRun::Backlash:
            break;
    }
    return MeasurePage::tr("Moves very slowly to and fro. Finds the backlash of the gear by the torque");
}

}  // namespace

MeasurePage::MeasurePage(RequestDesk& desk, QWidget* parent)
    : AskingPanel(desk, parent),
      m_model(new FiguresModel(this)),
      m_table(makeTable()),
      m_chart(new ResponseChart(this)),
      m_torque(new ChoiceButton(tr("Torque"), tr("Show the torque in place of the tracking error"), this)),
      m_first(new ValueLabel(tr("First tuning"), fonts::label(), {}, this)),
      m_state(new ValueLabel(tr("The run or its result"), fonts::label(), {}, this)),
      m_notice(new ValueLabel(tr("Refused"), fonts::label(), {}, this)),
      m_next(new CommandButton(tr("Next"), tr("The next step of the first tuning"), desk, *m_notice, this)),
      m_start(
          new CommandButton(tr("Measure …"), tr("Move the axis through this run. Asks first"), desk, *m_notice, this))
{
    build();
    connect(m_next, &QPushButton::clicked, this, &MeasurePage::next);
    connect(m_start, &QPushButton::clicked, this, &MeasurePage::startOrEnd);
    connect(m_torque, &QToolButton::toggled, this, [this](bool on) {
        m_chart->choose(on ? ResponseChart::Quantity::Torque : ResponseChart::Quantity::Error);
    });
    choose(TuningRun::Step);
}

void MeasurePage::build()
{
    auto* const column = new QVBoxLayout(&controls());
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    for (ValueLabel* const line : {m_first, m_state, m_notice}) {
        line->setStretching(true);
    }
    m_first->setLines(2);
    m_state->setLines(2);
    m_notice->setCollapsing(true);
    auto* const guide = new QHBoxLayout;
    guide->addWidget(m_first, 1);
    guide->addWidget(m_next);
    auto* const buttons = new QHBoxLayout;
    buttons->setSpacing(4);
    for (const TuningRun run : kTuningRuns) {
        auto* const choice = new ChoiceButton(runName(run), runHelp(run), this);
        choice->setAutoExclusive(true);
        choice->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        connect(choice, &QToolButton::clicked, this, [this, run] { choose(run); });
        m_choices[static_cast<std::size_t>(run)] = choice;
        buttons->addWidget(choice);
    }
    buttons->addWidget(m_start);
    auto* const figures = new QHBoxLayout;
    auto* const picture = new QVBoxLayout;
    picture->setSpacing(2);
    picture->addWidget(m_chart, 1);
    picture->addWidget(m_torque, 0, Qt::AlignRight);
    figures->addLayout(picture, 1);
    figures->addWidget(m_table, 1);
    column->addLayout(guide);
    column->addLayout(buttons);
    column->addWidget(m_state);
    column->addLayout(figures, 1);
    column->addWidget(m_notice);
}

QTableView* MeasurePage::makeTable()
{
    QTableView* const table = makeReadTable(tr("Figures"), *m_model, this);
    table->verticalHeader()->setDefaultSectionSize(table->fontMetrics().lineSpacing() + 2);
    QHeaderView* const header = table->horizontalHeader();
    header->setSectionResizeMode(FiguresModel::Name, QHeaderView::Stretch);
    for (const int column : {FiguresModel::Before, FiguresModel::After}) {
        header->setSectionResizeMode(column, QHeaderView::ResizeToContents);
    }
    return table;
}

void MeasurePage::setAxis(Axis axis)
{
    m_axis = axis;
    showStatus(StationStatus(m_status));
}

void MeasurePage::choose(TuningRun run)
{
    m_run = run;
    m_choices[static_cast<std::size_t>(run)]->setChecked(true);
    showStatus(StationStatus(m_status));
}

const TuningPlan& MeasurePage::plan(TuningRun run) const
{
    return m_status.tuning->plans[axisIndex(m_axis)][static_cast<std::size_t>(run)];
}

QString MeasurePage::obstacle(TuningRun run) const
{
    const QString refused = m_status.permissions.reason(actionOf(Action::TuneAzimuth, m_axis));
    return refused.isEmpty() ? plan(run).obstacle : refused;
}

void MeasurePage::showStatus(const StationStatus& status)
{
    const bool wasRunning = m_status.tuning->running.has_value();
    m_status = status;
    if (const auto running = status.tuning->running; running && !wasRunning) {
        m_run = *running;  // only at the start, because the operator may then select the figures of another run
        m_choices[static_cast<std::size_t>(m_run)]->setChecked(true);
    }
    const BeforeAndAfter results = resultsOf(*status.tuning, m_axis, m_run);
    m_model->show(results);
    m_chart->show(results);
    const bool runs = status.tuning->running.has_value();
    m_start->setCommand(runs ? tr("End run") : tr("Measure …"),
                        runs ? tr("End the run. The mount holds") : tr("Move the axis through this run. Asks first"));
    m_start->setBlocked(runs ? status.permissions.reason(Action::EndTuning) : obstacle(m_run));
    showRun();
    showFirstTuning();
    showWhetherPossible(status);
}

void MeasurePage::showRun()
{
    const TuningStatus& tuning = *m_status.tuning;
    if (tuning.running) {
        m_state->setValue(tr("%1 of the %2: %3 % done, %4 left. STOP or any other command ends it.")
                              .arg(runName(*tuning.running), name(tuning.axis))
                              .arg(100.0 * tuning.done, 0, 'f', 0)
                              .arg(waitText(tuning.left)),
                          Tone::Advisory, Symbol::Advisory);
        return;
    }
    const auto& outcome = tuning.outcome;
    if (outcome && outcome->failed && outcome->axis == m_axis && outcome->run == m_run) {
        m_state->setValue(outcome->text, Tone::Warning, Symbol::Warning);
        return;
    }
    if (const TuningResult* const shown = resultInForce(m_status, m_axis, m_run)) {
        m_state->setValue(shown->verdict.join(QLatin1Char(' ')), shown->good ? Tone::Normal : Tone::Warning,
                          shown->good ? Symbol::None : Symbol::Warning);
        return;
    }
    m_state->setValue(plan(m_run).obstacle.isEmpty() ? plan(m_run).text : plan(m_run).obstacle, Tone::Secondary);
}

void MeasurePage::showFirstTuning()
{
    const FirstTuning first = firstTuning(m_status, m_axis);
    m_first->setValue(first.text);
    if (first.reads) {
        m_next->setCommand(tr("Read gains"), tr("Read the gains of this drive. Nothing moves"));
        m_next->setBlocked(m_status.permissions.reason(actionOf(Action::ReadAzimuthGains, m_axis)));
    } else if (first.run) {
        m_next->setCommand(tr("Next …"), runHelp(*first.run));
        m_next->setBlocked(obstacle(*first.run));
    } else {
        m_next->setCommand(tr("Gains"), tr("Show the gains of this drive"));
        m_next->setBlocked({});
    }
}

void MeasurePage::next()
{
    const FirstTuning first = firstTuning(m_status, m_axis);
    if (first.reads) {
        m_next->ask(request::ReadGains{m_axis});
    } else if (first.run) {
        choose(*first.run);
        start(*first.run);
    } else {
        Q_EMIT gainsWanted();
    }
}

void MeasurePage::startOrEnd()
{
    if (m_status.tuning->running) {
        m_start->ask(request::EndTuning{});
    } else {
        start(m_run);
    }
}

void MeasurePage::start(TuningRun run)
{
    askFirst({.title = tr("Move the %1?").arg(name(m_axis)),
              .text = tr("%1\n\nKeep people and ropes clear of the antenna. STOP or any other command ends the run.")
                          .arg(plan(run).text),
              .act = tr("Move the axis"),
              .request = request::StartTuning{m_axis, run},
              .action = actionOf(Action::TuneAzimuth, m_axis)},
             m_status);
}

}  // namespace boresight::ui

#include "moc_measure_page.cpp"
