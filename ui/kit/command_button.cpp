// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/command_button.h"

#include "ui/kit/value_label.h"

namespace boresight::ui {

CommandButton::CommandButton(const QString& text, const QString& help, RequestDesk& desk, ValueLabel& notice,
                             QWidget* parent)
    : QPushButton(text, parent), m_desk(desk), m_notice(notice), m_text(text), m_help(help)
{
    setFont(fonts::label());
    setAccessibleName(text);
    setAutoDefault(false);
    showHelp();
}

void CommandButton::ask(const Request& request)
{
    await([&](QObject* asker, const RequestDesk::Reply& reply) { m_desk.send(request, asker, reply); });
}

void CommandButton::await(const std::function<void(QObject*, const RequestDesk::Reply&)>& send)
{
    ++m_waiting;
    showWaiting();
    send(this, [this, text = m_text](const std::optional<Error>& error) {
        --m_waiting;
        showWaiting();
        if (error) {
            m_notice.setValue(tr("%1: %2").arg(text, error->text), Tone::Warning, Symbol::Warning);
            Q_EMIT refused();
        } else {
            m_notice.setValue({});
            Q_EMIT accepted();
        }
    });
}

void CommandButton::setBlocked(const QString& reason)
{
    if (reason != m_reason) {
        m_reason = reason;
        if (!reason.isEmpty() && hasFocus()) {
            parentWidget()->setFocus(Qt::OtherFocusReason);  // not to the next button: a second press would act there
        }
        setEnabled(reason.isEmpty());
        showHelp();
    }
}

void CommandButton::setCommand(const QString& text, const QString& help)
{
    if (text == m_text && help == m_help) {
        return;
    }
    m_text = text;
    m_help = help;
    setAccessibleName(text);
    showWaiting();
    showHelp();
}

void CommandButton::showWaiting()
{
    setText(m_waiting > 0 ? m_text + QLatin1Char('\n') + tr("requested") : m_text);
}

void CommandButton::showHelp()
{
    const QString text = m_reason.isEmpty() ? m_help : tr("%1: %2").arg(m_text, m_reason);
    setToolTip(text);
    setAccessibleDescription(text);
}

QSize CommandButton::sizeHint() const
{
    const QFontMetrics metrics = fontMetrics();
    const int text = std::max(metrics.horizontalAdvance(m_text), metrics.horizontalAdvance(tr("requested")));
    return {std::max(text + 2 * kGrid, kTouchSize), std::max(2 * metrics.lineSpacing() + 8, kTouchSize)};
}

}  // namespace boresight::ui

#include "moc_command_button.cpp"
