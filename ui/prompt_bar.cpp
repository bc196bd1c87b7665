// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/prompt_bar.h"

#include "ui/value_label.h"

#include <QGridLayout>

namespace boresight::ui {

PromptBar::PromptBar(const QString& accessibleName, QWidget* parent, const QString& widest)
    : QFrame(parent),
      m_text(new ValueLabel(accessibleName, fonts::text(), widest, this)),
      m_notice(new ValueLabel(tr("Refused"), fonts::label(), {}, this)),
      m_buttons(new QHBoxLayout)
{
    setFrameStyle(QFrame::Box | QFrame::Plain);
    setAutoFillBackground(true);
    setAccessibleName(accessibleName);
    m_notice->setStretching(true);
    auto* const grid = new QGridLayout(this);
    grid->setContentsMargins(8, 6, 6, 6);
    grid->setVerticalSpacing(2);
    grid->addWidget(m_text, 0, 0);
    grid->addWidget(m_notice, 1, 0);
    grid->addLayout(m_buttons, 0, 1, 2, 1);
    hide();
}

void PromptBar::addButton(QWidget& button)
{
    m_buttons->addWidget(&button);
}

void PromptBar::setLines(int lines)
{
    m_text->setLines(lines);
}

void PromptBar::setText(const QString& text)
{
    m_text->setValue(text);
}

}  // namespace boresight::ui
