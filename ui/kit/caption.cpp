// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/caption.h"

#include "ui/kit/theme.h"

namespace boresight::ui {

QLabel* makeCaption(const QString& text, QWidget* parent)
{
    auto* const label = new QLabel(text, parent);
    label->setFont(fonts::label());
    return label;
}

QLabel* makeCaption(const QString& text, QWidget& field)
{
    QLabel* const label = makeCaption(text, field.parentWidget());
    label->setBuddy(&field);
    return label;
}

}  // namespace boresight::ui
