// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/request.h"
#include "ui/kit/request_desk.h"

#include <QPushButton>

#include <functional>

// A button that asks the station for something. It shows "requested" until the station has answered, puts a refusal
// into the notice line next to it, and while it cannot act it is disabled and its tooltip says why.
namespace boresight::ui {

class ValueLabel;

class CommandButton : public QPushButton
{
    Q_OBJECT

public:
    // `help` says what the button does, with its key.
    CommandButton(const QString& text, const QString& help, RequestDesk& desk, ValueLabel& notice,
                  QWidget* parent = nullptr);

    void ask(const Request& request);
    // The same for an asking that goes another way; `send` gets the asker and what must be called with the answer.
    void await(const std::function<void(QObject*, const RequestDesk::Reply&)>& send);
    void setBlocked(const QString& reason);                     // empty: can act
    void setCommand(const QString& text, const QString& help);  // for a button that changes its part

    [[nodiscard]] const QString& obstacle() const { return m_reason; }
    [[nodiscard]] bool isWaiting() const { return m_waiting > 0; }

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

Q_SIGNALS:
    void accepted();
    void refused();

private:
    void showWaiting();
    void showHelp();

    RequestDesk& m_desk;
    ValueLabel& m_notice;
    QString m_text;
    QString m_help;
    QString m_reason;
    int m_waiting = 0;
};

// The smallest size a gloved finger hits: 44 px (ui.md, "touch and glove").
inline constexpr int kTouchSize = 44;

}  // namespace boresight::ui
