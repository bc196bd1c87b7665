// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/wheel_guard.h"

#include <QAbstractSpinBox>
#include <QComboBox>
#include <QEvent>
#include <QSlider>

namespace boresight::ui {

void WheelGuard::watch(QWidget& widget)
{
    if (qobject_cast<QAbstractSpinBox*>(&widget) == nullptr && qobject_cast<QComboBox*>(&widget) == nullptr &&
        qobject_cast<QSlider*>(&widget) == nullptr) {
        return;
    }
    if (widget.focusPolicy() == Qt::WheelFocus) {
        widget.setFocusPolicy(Qt::StrongFocus);
    }
    widget.installEventFilter(this);  // once more does nothing more
}

// An event that is not accepted goes on to the page, which scrolls.
bool WheelGuard::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() != QEvent::Wheel || qobject_cast<QWidget*>(watched)->hasFocus()) {
        return QObject::eventFilter(watched, event);
    }
    event->ignore();
    return true;
}

}  // namespace boresight::ui

#include "moc_wheel_guard.cpp"
