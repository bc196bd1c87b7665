// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/log/log_panel.h"

#include "ui/kit/choice_button.h"
#include "ui/kit/push_button.h"
#include "ui/kit/symbol.h"
#include "ui/log/alarms_page.h"
#include "ui/log/log_model.h"
#include "ui/log/log_page.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace boresight::ui {

LogPanel::LogPanel(RequestDesk& desk, bool sound, QWidget* parent)
    : QWidget(parent),
      m_model(new LogModel(this)),
      m_events(new LogPage(*m_model, LogPage::Lines::All, this)),
      m_motions(new LogPage(*m_model, LogPage::Lines::MotionStarts, this)),
      m_alarms(new AlarmsPage(desk, sound, this)),
      m_choice(new QHBoxLayout),
      m_pages(new QStackedWidget(this)),
      m_timing(new QLabel(this)),
      m_alarmsChoice(
          addPage(*m_alarms, tr("Alarms"), tr("Active alarms, and all alarms since the start of the window")))
{
    connect(m_alarms, &AlarmsPage::beepWanted, this, &LogPanel::beepWanted);
    connect(m_alarms, &AlarmsPage::soundChanged, this, &LogPanel::soundChanged);
    addPage(*m_motions, tr("Why did it move?"), tr("Who moved the mount, and why"));
    m_eventsChoice = addPage(*m_events, tr("Events"), tr("Every line of the log"));
    m_eventsChoice->click();
    addDiagnosticsButton();
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(6, 6, 6, 6);
    column->addLayout(m_choice);
    column->addWidget(m_pages, 1);
    m_timing->setWordWrap(true);
    m_timing->setTextInteractionFlags(Qt::TextSelectableByMouse);
    column->addWidget(m_timing);
}

void LogPanel::addDiagnosticsButton()
{
    QPushButton* const button = makePushButton(
        {.text = tr("Bundle …"),
         .name = tr("Save diagnostics …"),
         .help = tr("Save diagnostics for a bug report: profile, logs, drives, the last minutes (Ctrl+B)")},
        this);
    button->setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Expanding);
    connect(button, &QPushButton::clicked, this, &LogPanel::diagnosticsWanted);
    m_choice->addWidget(button);
}

ChoiceButton* LogPanel::addPage(QWidget& page, const QString& text, const QString& help)
{
    m_pages->addWidget(&page);
    auto* const button = new ChoiceButton(text, help, this);
    button->setAutoExclusive(true);
    button->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);  // all of equal width, whatever their text
    connect(button, &ChoiceButton::toggled, this, [this, &page](bool on) {
        if (on) {
            m_pages->setCurrentWidget(&page);
        }
    });
    m_choice->addWidget(button, 1);
    return button;
}

void LogPanel::showStatus(const StationStatus& status)
{
    m_alarms->showStatus(status);
    m_timing->setText(tr("Control ticks: 99 % are late by at most %1 ms, the worst by %2 ms. %3")
                          .arg(status.timing.lateP99.count() * 1e3, 0, 'f', 1)
                          .arg(status.timing.lateWorst.count() * 1e3, 0, 'f', 1)
                          .arg(status.timing.scheduling));
    const auto waits = [](const Alarm& alarm) { return !alarm.acknowledged; };
    const auto first = std::ranges::find_if(status.alarms, waits);
    m_alarmsChoice->setText(first == status.alarms.end()
                                ? tr("Alarms")
                                : characterOf(first->severity) +
                                      tr("Alarms (%1)").arg(std::ranges::count_if(status.alarms, waits)));
}

void LogPanel::append(const std::vector<LogEntry>& entries)
{
    m_model->append(entries);
}

void LogPanel::showAlarm(const Alarm& alarm)
{
    if (const std::optional<int> row = m_model->lineOf(alarm)) {
        m_eventsChoice->setChecked(true);
        m_events->reveal(*row);
    } else {
        showAlarms();
    }
}

void LogPanel::showAlarms()
{
    m_alarmsChoice->setChecked(true);
}

}  // namespace boresight::ui

#include "moc_log_panel.cpp"
