// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/stop_keys.h"

#include "ui/kit/asking_panel.h"

#include <QApplication>
#include <QKeyEvent>
#include <QWidget>
#include <QWindow>

namespace boresight::ui {

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
    const bool used = press->key() == Qt::Key_Escape && (closeQuestion() || m_firstUse());
    if (!press->isAutoRepeat() && !used) {
        Q_EMIT stopPressed();
    }
    return true;  // seen first by the native window, so no control below it gets the key
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
