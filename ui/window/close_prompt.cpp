// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/close_prompt.h"

#include <QPushButton>

namespace boresight::ui {

namespace {

QString question()
{
    return ClosePrompt::tr("Stop the mount and close?");
}

QString closingText()
{
    return ClosePrompt::tr("Stopping and closing …");
}

}  // namespace

ClosePrompt::ClosePrompt(QWidget* parent) : PromptBar(tr("Close"), {question(), closingText()}, 2, parent)
{
    connect(addButton(tr("Stop and close")), &QPushButton::clicked, this, &ClosePrompt::confirm);
    connect(addButton(tr("Keep open")), &QPushButton::clicked, this, &QWidget::hide);
}

void ClosePrompt::ask()
{
    setText(question());
    show();
}

void ClosePrompt::confirm()
{
    m_confirmed = true;
    setText(closingText());
    Q_EMIT confirmed();
}

void ClosePrompt::withdraw()
{
    if (!m_confirmed) {
        hide();
    }
}

}  // namespace boresight::ui

#include "moc_close_prompt.cpp"
