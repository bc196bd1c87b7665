// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/hold/jog_button.h"

#include "ui/kit/command_button.h"
#include "ui/kit/theme.h"

#include <QKeyEvent>
#include <QMouseEvent>

namespace boresight::ui {

namespace {
// An X server repeats a pressed key as pairs of release and press. Qt detects this only if both have arrived.
constexpr std::chrono::milliseconds kKeyBounce{30};
}  // namespace

JogButton::JogButton(const QString& text, const QString& help, QWidget* parent)
    : QPushButton(text, parent), m_help(help)
{
    setFont(fonts::label());
    setAccessibleName(help);
    setToolTip(help);
    setFocusPolicy(Qt::NoFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    m_bounce.setSingleShot(true);
    m_bounce.setTimerType(Qt::PreciseTimer);
    m_bounce.setInterval(kKeyBounce);
    connect(&m_bounce, &QTimer::timeout, this, &JogButton::letGo);
}

void JogButton::setKeyHeld(bool on)
{
    setFocusPolicy(on ? Qt::StrongFocus : Qt::NoFocus);
}

void JogButton::setHelp(const QString& help)
{
    if (help != m_help) {
        m_help = help;
        setAccessibleName(help);
        showHelp();
    }
}

void JogButton::showHelp()
{
    setToolTip(m_reason.isEmpty() ? m_help : tr("%1: %2").arg(m_help, m_reason));
}

void JogButton::setBlocked(const QString& reason)
{
    if (reason != m_reason) {
        m_reason = reason;
        showHelp();
        setAccessibleDescription(reason);
        setEnabled(reason.isEmpty());
    }
}

void JogButton::hold()
{
    m_bounce.stop();
    if (!m_held) {
        m_held = true;
        setDown(true);
        Q_EMIT holdBegan();
    }
}

void JogButton::letGo()
{
    m_bounce.stop();
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
        case QEvent::FocusOut:
            letGo();
            break;
        default:
            break;
    }
    return QPushButton::event(event);
}

void JogButton::mousePressEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton) {
        hold();
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

// Only Space keeps it pressed. Enter is a press that ends at once, as in every dialog.
void JogButton::keyPressEvent(QKeyEvent* event)
{
    if (event->key() != Qt::Key_Space) {
        QPushButton::keyPressEvent(event);
    } else if (!event->isAutoRepeat()) {
        hold();
    }
}

void JogButton::keyReleaseEvent(QKeyEvent* event)
{
    if (event->key() != Qt::Key_Space) {
        QPushButton::keyReleaseEvent(event);
    } else if (!event->isAutoRepeat() && m_held) {
        m_bounce.start();
    }
}

}  // namespace boresight::ui

#include "moc_jog_button.cpp"
