// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>

// A combo box for fingers: the field and each line of its list have the height of a finger.
namespace boresight::ui {

class TouchCombo : public QComboBox
{
    Q_OBJECT

public:
    TouchCombo(const QString& name, const QString& help, QWidget* parent = nullptr);

    void setLines(const QStringList& lines);  // selects nothing and emits no signal
};

}  // namespace boresight::ui
