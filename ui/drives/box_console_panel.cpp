// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/drives/box_console_panel.h"

#include "ui/drives/sensor_offsets_row.h"
#include "ui/kit/command_button.h"
#include "ui/kit/value_label.h"

#include <QHBoxLayout>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QScrollBar>
#include <QVBoxLayout>

namespace boresight::ui {

BoxConsolePanel::BoxConsolePanel(ProfileDraft& draft, RequestDesk& desk, QWidget* parent)
    : AskingPanel(desk, parent),
      m_console(new QWidget(this)),
      m_answers(new QPlainTextEdit(this)),
      m_line(new QLineEdit(this)),
      m_notice(new ValueLabel(tr("Refused"), fonts::label(), {}, this)),
      m_offsets(new SensorOffsetsRow(draft, desk, *m_notice, this)),
      m_send(new CommandButton(tr("Send line"),
                               tr("Send the line to the control box as it is (Enter). The mount must stand still."),
                               desk, *m_notice, this)),
      m_homeRun(new CommandButton(tr("Home run …"),
                                  tr("The rotator drives its axes to its own switches, and counts from there again."),
                                  desk, *m_notice, this))
{
    build();
    connect(m_send, &QPushButton::clicked, this, &BoxConsolePanel::send);
    connect(m_line, &QLineEdit::returnPressed, this, &BoxConsolePanel::send);
    connect(m_send, &CommandButton::accepted, m_line, &QLineEdit::clear);
    connect(m_homeRun, &QPushButton::clicked, this, &BoxConsolePanel::askForHomeRun);
}

void BoxConsolePanel::build()
{
    m_answers->setReadOnly(true);
    m_answers->setFont(fonts::text());
    m_answers->setAccessibleName(tr("Answers of the control box"));
    m_line->setFont(fonts::text());
    m_line->setMinimumHeight(kTouchSize);
    m_line->setAccessibleName(tr("Line for the control box"));
    m_line->setToolTip(tr("A command in the words of the control box. Lines that move the rotator are refused."));
    m_notice->setStretching(true);
    m_notice->setCollapsing(true);
    auto* const row = new QHBoxLayout;
    row->setSpacing(4);
    row->addWidget(m_line, 1);
    row->addWidget(m_send);
    auto* const typed = new QVBoxLayout(m_console);
    typed->setContentsMargins(0, 0, 0, 0);
    typed->setSpacing(6);
    typed->addWidget(m_answers, 1);
    typed->addLayout(row);
    auto* const column = new QVBoxLayout(&controls());
    column->setContentsMargins(6, 6, 6, 6);
    column->setSpacing(6);
    column->addWidget(m_offsets);
    column->addWidget(m_console, 1);
    column->addWidget(m_homeRun, 0, Qt::AlignLeft);
    column->addWidget(m_notice);
    column->addStretch(0);
}

void BoxConsolePanel::send()
{
    if (m_send->isEnabled()) {
        m_send->ask(request::TypeLine{.line = m_line->text().toStdString()});
    }
}

void BoxConsolePanel::askForHomeRun()
{
    askFirst(
        {.title = tr("Drive the rotator to its own switches?"),
         .text = tr("The rotator turns both axes by itself until they meet its switches, and counts from there "
                    "again. The limits, the keep-outs and the Sun are not respected meanwhile. Look at the antenna "
                    "and its cable first. STOP ends the run.\n\nBoresight takes the rotator over again when it "
                    "has stood still for some seconds. Then compare the angles with the antenna."),
         .act = tr("Make the home run"),
         .request = request::MakeHomeRun{},
         .action = Action::MakeHomeRun},
        m_status);
}

void BoxConsolePanel::showStatus(const StationStatus& status)
{
    m_status = status;
    m_send->setBlocked(status.permissions.reason(Action::TypeLine));
    m_homeRun->setVisible(status.capabilities.makesHomeRuns);
    m_homeRun->setBlocked(status.permissions.reason(Action::MakeHomeRun));
    m_console->setVisible(status.console.has_value());
    m_offsets->showStatus(status);
    showWhetherPossible(status);
    const QStringList lines = status.console.value_or(QStringList());
    if (lines != m_shown) {
        m_shown = lines;
        m_answers->setPlainText(lines.join(QLatin1Char('\n')));
        m_answers->verticalScrollBar()->setValue(m_answers->verticalScrollBar()->maximum());
    }
}

}  // namespace boresight::ui

#include "moc_box_console_panel.cpp"
