// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTimer>

namespace boresight::ui {

// The first moments after a button got another meaning. A press then was meant for the button before, for example the
// second press of a double click, and has to do nothing. Gui thread.
class PressGuard
{
public:
    explicit PressGuard(QObject* parent) : m_timer(new QTimer(parent))
    {
        m_timer->setSingleShot(true);
        m_timer->setInterval(kTime);
    }

    void begin() { m_timer->start(); }
    [[nodiscard]] bool isOver() const { return !m_timer->isActive(); }

private:
    static constexpr int kTime = 700;  // ms

    QTimer* m_timer;
};

}  // namespace boresight::ui
