// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDoubleSpinBox>

// A number with a point, whatever language the desktop speaks. A comma is taken for the point: Qt leaves it out of what
// is typed, and 12,5 would be 125.
namespace boresight::ui {

class DecimalBox : public QDoubleSpinBox
{
    Q_OBJECT

public:
    explicit DecimalBox(QWidget* parent = nullptr);

    [[nodiscard]] QValidator::State validate(QString& input, int& position) const override;
    [[nodiscard]] double valueFromText(const QString& text) const override;
};

}  // namespace boresight::ui
