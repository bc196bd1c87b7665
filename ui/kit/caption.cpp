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

QLabel* makeGroupCaption(const QString& text, QWidget* parent)
{
    QLabel* const label = makeCaption(text, parent);
    QFont font = fonts::label();
    font.setPointSizeF(font.pointSizeF() * 0.85);
    font.setBold(true);
    font.setCapitalization(QFont::AllUppercase);
    font.setLetterSpacing(QFont::PercentageSpacing, 104);
    label->setFont(font);
    label->setForegroundRole(QPalette::PlaceholderText);  // the secondary colour, in every theme
    return label;
}

}  // namespace boresight::ui
