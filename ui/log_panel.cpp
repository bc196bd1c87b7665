// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/log_panel.h"

#include "ui/choice_button.h"
#include "ui/log_page.h"

#include <QHBoxLayout>
#include <QStackedWidget>
#include <QVBoxLayout>

namespace boresight::ui {

LogPanel::LogPanel(QWidget* parent)
    : QWidget(parent),
      m_model(new LogModel(this)),
      m_events(new LogPage(*m_model, LogPage::Lines::All, this)),
      m_motions(new LogPage(*m_model, LogPage::Lines::MotionStarts, this)),
      m_choice(new QHBoxLayout),
      m_pages(new QStackedWidget(this))
{
    addPage(*m_motions, tr("Why did it move?"), tr("Who moved the mount, and why"));
    addPage(*m_events, tr("Events"), tr("Every line of the log"))->click();
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(6, 6, 6, 6);
    column->addLayout(m_choice);
    column->addWidget(m_pages, 1);
}

ChoiceButton* LogPanel::addPage(QWidget& page, const QString& text, const QString& help)
{
    m_pages->addWidget(&page);
    auto* const button = new ChoiceButton(text, help, this);
    button->setAutoExclusive(true);
    connect(button, &ChoiceButton::toggled, this, [this, &page](bool on) {
        if (on) {
            m_pages->setCurrentWidget(&page);
        }
    });
    m_choice->addWidget(button, 1);
    return button;
}

void LogPanel::append(const std::vector<LogEntry>& entries)
{
    m_model->append(entries);
}

}  // namespace boresight::ui
