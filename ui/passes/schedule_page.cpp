// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/passes/schedule_page.h"

#include "ui/kit/command_button.h"
#include "ui/kit/format.h"
#include "ui/kit/push_button.h"
#include "ui/kit/read_table.h"
#include "ui/kit/value_label.h"
#include "ui/look/paint.h"
#include "ui/passes/schedule_table.h"
#include "ui/passes/watch_editor.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QTableView>
#include <QVBoxLayout>

#include <algorithm>

namespace boresight::ui {

namespace {

QString nextText(const ScheduleStatus& schedule, bool isWatching, UtcTime now)
{
    const auto next = std::ranges::find_if(schedule.plan.chosen,
                                           [&](const schedule::WatchedPass& pass) { return pass.begins() > now; });
    if (next == schedule.plan.chosen.end()) {
        return isWatching ? SchedulePage::tr("No pass within a day.")
                          : SchedulePage::tr("No satellite is watched. Add one on the page Coming.");
    }
    return SchedulePage::tr("Next: %1 at %2Z, in %3.")
        .arg(next->name, clockText(next->begins()), waitText(next->begins() - now));
}

QString reportText(const schedule::NightReport& report)
{
    return report.passes.empty() ? QString()
                                 : SchedulePage::tr("Report: %1 of %2 passes tracked to the end.")
                                       .arg(report.done())
                                       .arg(report.passes.size());
}

QString stateText(const ScheduleStatus& schedule, bool isWatching, UtcTime now)
{
    const QString state = schedule.armed ? SchedulePage::tr("Armed. The mount moves by itself for each pass.")
                                         : SchedulePage::tr("Off. Nothing moves by itself.");
    QStringList sentences{state};
    if (!schedule.why.isEmpty()) {
        sentences << schedule.why.left(1).toUpper() + schedule.why.mid(1) + QLatin1Char('.');
    }
    sentences << nextText(schedule, isWatching, now) << reportText(schedule.report);
    return sentences.join(QLatin1Char(' ')).trimmed();
}

// The result of a rehearsal in words.
QString rehearsalText(const RehearsedNight& night)
{
    QStringList sentences{SchedulePage::tr("Rehearsal: %1 of %2 passes are tracked to the end.")
                              .arg(night.report.done())
                              .arg(night.plan.chosen.size()),
                          SchedulePage::tr("The azimuth axis is used from %1 to %2.")
                              .arg(angleText(night.leastAzimuth, 0), angleText(night.mostAzimuth, 0))};
    if (!night.disarmed.isEmpty()) {
        sentences << SchedulePage::tr("The schedule would end at %1Z: %2.").arg(clockText(night.to), night.disarmed);
    }
    if (!night.remarks.empty()) {
        sentences << SchedulePage::tr("Warnings in the table: %1.").arg(night.remarks.size());
    }
    return sentences.join(QLatin1Char(' '));
}

}  // namespace

SchedulePage::SchedulePage(ProfileDraft& draft, RequestDesk& desk, QWidget* parent)
    : QWidget(parent),
      m_night(new ScheduleTable(this)),
      m_table(makeReadTable(tr("Schedule of passes"), *m_night, this)),
      m_state(new ValueLabel(tr("State of the schedule"), fonts::label(), {}, this)),
      m_refused(new ValueLabel(tr("Refused"), fonts::label(), {}, this)),
      m_rehearsed(new ValueLabel(tr("Rehearsal"), fonts::label(), {}, this)),
      m_arm(new CommandButton(tr("Arm schedule"), {}, desk, *m_refused, this)),
      m_rehearse(new CommandButton(tr("Rehearse"), {}, desk, *m_refused, this)),
      m_watched(new WatchEditor(draft, desk, this))
{
    build();
    connect(m_arm, &QPushButton::clicked, this, &SchedulePage::armOrDisarm);
    connect(m_rehearse, &QPushButton::clicked, this,
            [this] { m_rehearse->ask(request::Rehearse{.on = !m_isRehearsing}); });
}

void SchedulePage::build()
{
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(6, 6, 6, 6);
    column->setSpacing(4);
    m_state->setLines(4);
    m_state->setStretching(true);
    m_refused->setLines(2);
    m_refused->setStretching(true);
    m_refused->setCollapsing(true);
    m_rehearsed->setLines(2);
    m_rehearsed->setStretching(true);
    m_rehearsed->setCollapsing(true);
    setEmphasis(*m_arm, Emphasis::Primary);
    auto* const top = new QHBoxLayout;
    top->setSpacing(kGrid);
    top->addWidget(m_state, 1);
    top->addWidget(m_rehearse, 0, Qt::AlignTop);
    top->addWidget(m_arm, 0, Qt::AlignTop);
    column->addLayout(top);
    column->addWidget(m_refused);
    column->addWidget(m_rehearsed);
    column->addWidget(m_table, 1);
    column->addWidget(m_watched);
    QHeaderView* const header = m_table->horizontalHeader();
    header->setSectionResizeMode(QHeaderView::ResizeToContents);
    header->setSectionResizeMode(ScheduleTable::What, QHeaderView::Stretch);
    // A reason is a sentence, which takes two lines of a narrow window.
    m_table->setWordWrap(true);
    m_table->verticalHeader()->setMinimumSectionSize(kRowHeight);
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
}

void SchedulePage::armOrDisarm()
{
    if (m_isArmed) {
        m_arm->ask(request::DisarmSchedule{});
    } else {
        m_arm->ask(request::ArmSchedule{});
    }
}

void SchedulePage::showStatus(const StationStatus& status)
{
    const ScheduleStatus& schedule = *status.schedule;
    m_isArmed = schedule.armed;
    m_arm->setCommand(
        m_isArmed ? tr("Disarm") : tr("Arm schedule"),
        m_isArmed ? tr("End the schedule. The mount holds") : tr("Let the mount track each listed pass by itself"));
    m_arm->setBlocked(m_isArmed ? QString() : status.permissions.reason(Action::ArmSchedule));
    m_state->setValue(stateText(schedule, !status.profile->schedule.watch.empty(), status.utc),
                      m_isArmed ? Tone::Normal : Tone::Secondary);
    showRehearsal(status);
    m_night->show(schedule, status.rehearsal.night.get(), status.utc);
    m_watched->showStatus(status);
}

void SchedulePage::showRehearsal(const StationStatus& status)
{
    const RehearsalStatus& rehearsal = status.rehearsal;
    m_isRehearsing = rehearsal.progress.has_value();
    m_rehearse->setCommand(m_isRehearsing ? tr("Stop rehearsal") : tr("Rehearse"),
                           m_isRehearsing ? tr("End the rehearsal without a result")
                                          : tr("Run the next 24 h now on a copy of the mount. Nothing moves"));
    if (m_isRehearsing) {
        m_rehearsed->setValue(tr("Rehearsing: %1 %").arg(std::lround(*rehearsal.progress * 100.0)), Tone::Secondary);
    } else if (rehearsal.night) {
        m_rehearsed->setValue(rehearsalText(*rehearsal.night), Tone::Normal);
    } else {
        m_rehearsed->setValue(rehearsal.problem, Tone::Secondary);
    }
}

}  // namespace boresight::ui

#include "moc_schedule_page.cpp"
