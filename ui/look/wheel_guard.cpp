// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/wheel_guard.h"

#include <QAbstractSpinBox>
#include <QComboBox>
#include <QEvent>
#include <QSlider>
#include <QTabBar>

namespace boresight::ui {

void WheelGuard::watch(QWidget& widget)
{
    if (qobject_cast<QAbstractSpinBox*>(&widget) == nullptr && qobject_cast<QComboBox*>(&widget) == nullptr &&
        qobject_cast<QSlider*>(&widget) == nullptr && qobject_cast<QTabBar*>(&widget) == nullptr) {
        return;
    }
    if (widget.focusPolicy() == Qt::WheelFocus) {
        widget.setFocusPolicy(Qt::StrongFocus);
    }
    widget.installEventFilter(this);  // installing it twice has no effect
}

// An event that is not accepted goes on to the page, which scrolls. Tabs never take it, even while they have the
// keyboard: a page must not change by accident.
bool WheelGuard::eventFilter(QObject* watched, QEvent* event)
{
    const bool takesWheel = qobject_cast<QWidget*>(watched)->hasFocus() && qobject_cast<QTabBar*>(watched) == nullptr;
    if (event->type() != QEvent::Wheel || takesWheel) {
        return QObject::eventFilter(watched, event);
    }
    event->ignore();
    return true;
}

}  // namespace boresight::ui

#include "moc_wheel_guard.cpp"
