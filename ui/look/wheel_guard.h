// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

// Scrolling a page with the mouse wheel must not change a number, a choice or a rate that comes under the pointer. The
// wheel changes a control only while it has the keyboard. Gui thread.
namespace boresight::ui {

class WheelGuard : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    // Does so if the wheel changes this widget.
    void watch(QWidget& widget);

    bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace boresight::ui
