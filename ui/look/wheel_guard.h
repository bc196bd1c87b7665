// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

// Who scrolls a page with the wheel of the mouse does not change a number, a choice or a rate that comes under the
// pointer on the way. The wheel changes it only while it has the keyboard. Gui thread.
namespace boresight::ui {

class WheelGuard : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    // If it is a widget that the wheel changes.
    void watch(QWidget& widget);

    bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace boresight::ui
