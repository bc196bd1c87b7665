// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/segments.h"

#include "ui/kit/choice_button.h"
#include "ui/look/paint.h"

#include <QHBoxLayout>
#include <QPainter>
#include <QStyleOption>

namespace boresight::ui {

Segments::Segments(QWidget* parent) : QWidget(parent), m_row(new QHBoxLayout(this))
{
    m_row->setContentsMargins(2, 2, 2, 2);
    m_row->setSpacing(0);
}

void Segments::add(ChoiceButton& choice)
{
    choice.setAutoRaise(true);  // this widget draws the edge
    m_row->addWidget(&choice);
}

void Segments::paintEvent(QPaintEvent*)
{
    QStyleOption option;
    option.initFrom(this);
    option.state.setFlag(QStyle::State_MouseOver, false);
    QPainter painter(this);
    paintButton(painter, option, Emphasis::Normal);
}

}  // namespace boresight::ui

#include "moc_segments.cpp"
