// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRadioButton>

// A radio button whose ring is seen in every theme: the style draws it in a shade of the ground, which is invisible on
// black.
namespace boresight::ui {

class PlaceButton : public QRadioButton
{
    Q_OBJECT

public:
    explicit PlaceButton(QWidget* parent = nullptr);

protected:
    void paintEvent(QPaintEvent* event) override;
};

}  // namespace boresight::ui
