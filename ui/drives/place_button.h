// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRadioButton>

// A radio button whose ring is visible in every theme. The style would draw it in a shade of the background, invisible
// on black.
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
