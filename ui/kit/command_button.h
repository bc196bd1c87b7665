// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/request.h"
#include "ui/kit/request_desk.h"

#include <QPushButton>

#include <functional>

// A button for a request to the station. It shows "requested" until the station has answered, and shows a refusal in
// the notice line next to it. While it cannot act it is disabled, and its tooltip gives the reason.
namespace boresight::ui {

class ValueLabel;

class CommandButton : public QPushButton
{
    Q_OBJECT

public:
    // `help` describes what the button does, and names its key.
    CommandButton(const QString& text, const QString& help, RequestDesk& desk, ValueLabel& notice,
                  QWidget* parent = nullptr);

    void ask(const Request& request);
    // The same for a request by another way. `send` receives the asker and the function to be called with the answer.
    void await(const std::function<void(QObject*, const RequestDesk::Reply&)>& send);
    void setBlocked(const QString& reason);                     // empty: can act
    void setCommand(const QString& text, const QString& help);  // for a button with a changing action

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

// The smallest size that a gloved finger can hit: 44 px (ui.md, "touch and glove").
inline constexpr int kTouchSize = 44;

}  // namespace boresight::ui
