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
    : QWidget(parent),
      m_answers(new QPlainTextEdit(this)),
      m_line(new QLineEdit(this)),
      m_notice(new ValueLabel(tr("Refused"), fonts::label(), {}, this)),
      m_offsets(new SensorOffsetsRow(draft, desk, *m_notice, this)),
      m_send(new CommandButton(tr("Send line"),
                               tr("Send the line to the control box as it is (Enter). The mount must stand still."),
                               desk, *m_notice, this))
{
    build();
    connect(m_send, &QPushButton::clicked, this, &BoxConsolePanel::send);
    connect(m_line, &QLineEdit::returnPressed, this, &BoxConsolePanel::send);
    connect(m_send, &CommandButton::accepted, m_line, &QLineEdit::clear);
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
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(6, 6, 6, 6);
    column->setSpacing(6);
    column->addWidget(m_offsets);
    column->addWidget(m_answers, 1);
    column->addLayout(row);
    column->addWidget(m_notice);
}

void BoxConsolePanel::send()
{
    if (m_send->isEnabled()) {
        m_send->ask(request::TypeLine{.line = m_line->text().toStdString()});
    }
}

void BoxConsolePanel::showStatus(const StationStatus& status)
{
    m_send->setBlocked(status.permissions.reason(Action::TypeLine));
    m_offsets->showStatus(status);
    const QStringList lines = status.console.value_or(QStringList());
    if (lines != m_shown) {
        m_shown = lines;
        m_answers->setPlainText(lines.join(QLatin1Char('\n')));
        m_answers->verticalScrollBar()->setValue(m_answers->verticalScrollBar()->maximum());
    }
}

}  // namespace boresight::ui

#include "moc_box_console_panel.cpp"
