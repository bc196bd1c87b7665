// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDoubleSpinBox>

// A number with a decimal point, whatever the language of the desktop. A comma counts as the point. Otherwise Qt would
// drop it, and 12,5 would become 125.
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
