// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/jog_button.h"

#include "ui/command_button.h"
#include "ui/theme.h"

#include <QMouseEvent>

namespace boresight::ui {

JogButton::JogButton(const QString& text, const QString& help, QWidget* parent)
    : QPushButton(text, parent), m_help(help)
{
    setFont(fonts::label());
    setAccessibleName(help);
    setToolTip(help);
    setFocusPolicy(Qt::NoFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void JogButton::setBlocked(const QString& reason)
{
    if (reason != m_reason) {
        m_reason = reason;
        setToolTip(reason.isEmpty() ? m_help : tr("%1: %2").arg(m_help, reason));
        setAccessibleDescription(reason);
        setEnabled(reason.isEmpty());
    }
}

void JogButton::letGo()
{
    if (m_held) {
        m_held = false;
        setDown(false);
        Q_EMIT holdEnded();
    }
}

QSize JogButton::sizeHint() const
{
    const int text = std::max(fontMetrics().horizontalAdvance(tr("requested")),
                              fontMetrics().size(Qt::TextShowMnemonic, this->text()).width());
    return {text + 20, std::max(kTouchSize, 2 * fontMetrics().lineSpacing() + 8)};
}

bool JogButton::event(QEvent* event)
{
    switch (event->type()) {
        case QEvent::EnabledChange:
        case QEvent::Hide:
        case QEvent::WindowDeactivate:
        case QEvent::UngrabMouse:
            letGo();
            break;
        default:
            break;
    }
    return QPushButton::event(event);
}

void JogButton::mousePressEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton && !m_held) {
        m_held = true;
        setDown(true);
        Q_EMIT holdBegan();
    }
}

void JogButton::mouseMoveEvent(QMouseEvent* event)
{
    if (!rect().contains(event->position().toPoint())) {
        letGo();
    }
}

void JogButton::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton) {
        letGo();
    }
}

}  // namespace boresight::ui
