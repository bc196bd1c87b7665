// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/decimal_box.h"

namespace boresight::ui {

namespace {

QString withPoint(QString text)
{
    return text.replace(QLatin1Char(','), QLatin1Char('.'));
}

}  // namespace

DecimalBox::DecimalBox(QWidget* parent) : QDoubleSpinBox(parent)
{
    setLocale(QLocale::c());
}

QValidator::State DecimalBox::validate(QString& input, int& position) const
{
    input = withPoint(input);
    return QDoubleSpinBox::validate(input, position);
}

double DecimalBox::valueFromText(const QString& text) const
{
    return QDoubleSpinBox::valueFromText(withPoint(text));
}

}  // namespace boresight::ui

#include "moc_decimal_box.cpp"
