// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/stop_keys.h"

#include "ui/kit/asking_panel.h"
#include "ui/kit/leavable.h"
#include "ui/window/alarm_card.h"

#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QTextEdit>
#include <QWidget>
#include <QWindow>

namespace boresight::ui {

namespace {

// The widget itself, or its nearest ancestor of this type.
template <class T>
T* around(QWidget* widget)
{
    while (widget != nullptr && qobject_cast<T*>(widget) == nullptr) {
        widget = widget->parentWidget();
    }
    return qobject_cast<T*>(widget);
}

// The editor that a list or a table has opened in one of its cells.
bool isCellEditor(QWidget* widget)
{
    return widget != nullptr && qobject_cast<QAbstractItemView*>(widget) == nullptr &&
           around<QAbstractItemView>(widget) != nullptr;
}

// A widget for typing or choosing.
bool isField(QWidget* widget)
{
    return qobject_cast<QLineEdit*>(widget) != nullptr || qobject_cast<QAbstractSpinBox*>(widget) != nullptr ||
           qobject_cast<QComboBox*>(widget) != nullptr || qobject_cast<QAbstractItemView*>(widget) != nullptr ||
           qobject_cast<QPlainTextEdit*>(widget) != nullptr || qobject_cast<QTextEdit*>(widget) != nullptr;
}

}  // namespace

StopKeys::StopKeys(QWidget& window) : QObject(&window), m_window(window)
{
    QApplication::instance()->installEventFilter(this);
}

bool StopKeys::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() != QEvent::KeyPress) {
        return false;
    }
    const auto* const press = static_cast<QKeyEvent*>(event);
    if (!isStop(watched, press->key())) {
        return false;
    }
    if (press->key() == Qt::Key_Escape && isCellEditor(QApplication::focusWidget())) {
        return false;  // its table reverts the typed text
    }
    if (press->isAutoRepeat()) {
        return true;
    }
    if (press->key() != Qt::Key_Escape || !leave()) {
        Q_EMIT stopPressed();
    }
    return true;  // the native window sees it first, so no control receives the key
}

// True if there was something to leave.
bool StopKeys::leave() const
{
    if (closeQuestion() || m_firstUse()) {
        return true;
    }
    QWidget* const focus = QApplication::focusWidget();
    if (focus == nullptr || focus->window() != &m_window) {
        return false;
    }
    if (isField(focus) || around<AlarmCard>(focus) != nullptr) {
        focus->clearFocus();
        return true;
    }
    for (QWidget* at = focus; at != nullptr; at = at->parentWidget()) {
        if (auto* const part = dynamic_cast<Leavable*>(at); part != nullptr && part->leave()) {
            return true;
        }
    }
    return false;
}

// True if one was open.
bool StopKeys::closeQuestion() const
{
    for (AskingPanel* const panel : m_window.findChildren<AskingPanel*>()) {
        if (panel->isVisible() && panel->isAsking()) {
            panel->cancel();
            return true;
        }
    }
    return false;
}

bool StopKeys::isStop(QObject* watched, int key) const
{
    if (key == Qt::Key_Pause || key == Qt::Key_F12) {
        return true;
    }
    if (key != Qt::Key_Escape || QApplication::activePopupWidget() != nullptr ||
        QApplication::activeModalWidget() != nullptr) {
        return false;
    }
    if (const auto* const widget = qobject_cast<QWidget*>(watched)) {
        return widget->window() == &m_window;
    }
    return watched == m_window.windowHandle();
}

}  // namespace boresight::ui

#include "moc_stop_keys.cpp"
