// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/prompt_bar.h"

#include "ui/kit/push_button.h"
#include "ui/kit/value_label.h"
#include "ui/kit/widest.h"

#include <QApplication>
#include <QGridLayout>
#include <QPushButton>

namespace boresight::ui {

PromptBar::PromptBar(const QString& accessibleName, const QStringList& texts, int lines, QWidget* parent)
    : QFrame(parent),
      m_text(new ValueLabel(accessibleName, fonts::text(), widestLine(fonts::text(), texts, lines), this)),
      m_notice(new ValueLabel(tr("Refused"), fonts::label(), {}, this)),
      m_buttons(new QHBoxLayout)
{
    setFrameStyle(QFrame::Box | QFrame::Plain);
    setAutoFillBackground(true);
    setAccessibleName(accessibleName);
    m_text->setLines(lines);
    m_notice->setStretching(true);
    m_notice->setLines(2);
    m_notice->setCollapsing(true);
    auto* const grid = new QGridLayout(this);
    grid->setContentsMargins(kGrid / 2, kGrid, kGrid / 2, kGrid);
    grid->setVerticalSpacing(2);
    m_buttons->setSpacing(kGrid);
    grid->addWidget(m_text, 0, 0);
    grid->addLayout(m_buttons, 0, 1);
    grid->addWidget(m_notice, 1, 0, 1, 2);
    hide();
}

void PromptBar::addButton(QWidget& button)
{
    m_buttons->addWidget(&button);
}

QPushButton* PromptBar::addButton(const QString& text)
{
    QPushButton* const button = makePushButton({.text = text}, this);
    addButton(*button);
    return button;
}

QPushButton* PromptBar::declining() const
{
    return qobject_cast<QPushButton*>(m_buttons->itemAt(m_buttons->count() - 1)->widget());
}

bool PromptBar::leave()
{
    declining()->click();
    return true;
}

void PromptBar::takeFocus()
{
    declining()->setFocus();
}

// Qt would give the keyboard to the next button, so that a second press acts there, or the next Esc only leaves it.
void PromptBar::hideEvent(QHideEvent* event)
{
    QWidget* const focus = QApplication::focusWidget();
    if (focus != nullptr && isAncestorOf(focus)) {
        focus->clearFocus();
    }
    QFrame::hideEvent(event);
}

void PromptBar::setText(const QString& text)
{
    m_text->setValue(text);
}

}  // namespace boresight::ui

#include "moc_prompt_bar.cpp"
