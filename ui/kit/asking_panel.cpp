// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/asking_panel.h"

#include "ui/kit/command_button.h"
#include "ui/kit/page_room.h"
#include "ui/kit/push_button.h"
#include "ui/kit/value_label.h"

#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>

namespace boresight::ui {

AskingPanel::AskingPanel(RequestDesk& desk, QWidget* parent)
    : QStackedWidget(parent),
      m_controls(new QWidget(this)),
      m_title(new QLabel(this)),
      m_text(new QPlainTextEdit(this)),
      m_typedName(new QLabel(this)),
      m_typed(new QLineEdit(this)),
      m_notice(new ValueLabel(tr("Refused"), fonts::label(), {}, this)),
      m_act(new CommandButton({}, {}, desk, *m_notice, this)),
      m_cancel(makePushButton({.text = tr("Cancel"), .help = tr("Close the question. Nothing is done.")}, this))
{
    addWidget(m_controls);
    addWidget(makeQuestionPage());
    keepHeightOfShownPage(*this);
    connect(m_act, &QPushButton::clicked, this, &AskingPanel::carryOut);
    connect(m_typed, &QLineEdit::returnPressed, m_act, &QPushButton::click);
    connect(m_act, &CommandButton::accepted, this, &AskingPanel::closeQuestion);
    connect(m_cancel, &QPushButton::clicked, this, &AskingPanel::closeQuestion);
}

QWidget* AskingPanel::makeQuestionPage()
{
    auto* const page = new QWidget(this);
    auto* const grid = new QGridLayout(page);
    m_title->setFont(fonts::text());
    m_title->setWordWrap(true);  // the name of a mount may be long
    m_text->setFont(fonts::label());
    m_text->setReadOnly(true);
    m_text->setTabChangesFocus(true);
    m_text->setAccessibleName(tr("What will happen"));
    for (QWidget* const one : {static_cast<QWidget*>(m_typedName), static_cast<QWidget*>(m_typed)}) {
        one->setFont(fonts::label());
    }
    m_typed->setMinimumHeight(kTouchSize);
    m_typedName->setBuddy(m_typed);
    m_notice->setStretching(true);
    m_notice->setLines(2);
    m_cancel->setMinimumSize(m_act->minimumSizeHint());
    m_act->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    m_cancel->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    grid->setContentsMargins(6, 6, 6, 6);
    grid->addWidget(m_title, 0, 0, 1, 2);
    grid->addWidget(m_text, 1, 0, 1, 2);
    grid->addWidget(m_typedName, 2, 0, 1, 2);
    grid->addWidget(m_typed, 3, 0, 1, 2);
    grid->addWidget(m_act, 4, 0);
    grid->addWidget(m_cancel, 4, 1);
    grid->addWidget(m_notice, 5, 0, 1, 2);
    return page;
}

void AskingPanel::askFirst(const Question& question, const StationStatus& status)
{
    m_question = question;
    m_asker = focusWidget();
    m_title->setText(question.title);
    m_text->setPlainText(question.text);
    m_act->setCommand(question.act, question.title);
    m_act->setBlocked({});
    m_notice->setValue({});
    const bool typing = !question.typedName.isEmpty();
    m_typedName->setText(question.typedName);
    m_typedName->setVisible(typing);
    m_typed->setAccessibleName(question.typedName);
    m_typed->setText(question.typed);
    m_typed->setVisible(typing);
    setCurrentIndex(1);
    if (typing) {
        m_typed->selectAll();
        m_typed->setFocus();
    } else {
        m_cancel->setFocus();
    }
    showWhetherPossible(status);
}

void AskingPanel::carryOut()
{
    if (!m_question.perform) {
        m_act->ask(m_question.request);
        return;
    }
    const auto perform = m_question.perform;
    const QString typed = m_typed->text().trimmed();
    closeQuestion();
    perform(typed);
}

// When the action becomes blocked, the text of the question may be out of date. The operator has to ask again.
void AskingPanel::showWhetherPossible(const StationStatus& status)
{
    const QString reason = isAsking() && m_question.action ? status.permissions.reason(*m_question.action) : QString();
    if (!reason.isEmpty()) {
        m_act->setBlocked(reason);
        m_notice->setValue(tr("Not now: %1").arg(reason), Tone::Warning, Symbol::Warning);
    }
}

void AskingPanel::closeQuestion()
{
    setCurrentIndex(0);
    if (m_asker) {
        m_asker->setFocus();
    }
}

void AskingPanel::hideEvent(QHideEvent* event)
{
    setCurrentIndex(0);  // a hidden question must not wait for a press
    QStackedWidget::hideEvent(event);
}

}  // namespace boresight::ui

#include "moc_asking_panel.cpp"
