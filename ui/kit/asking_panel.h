// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/request.h"
#include "core/messages/station_status.h"

#include <QStackedWidget>

#include <functional>
#include <optional>

class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QPushButton;

// A panel with buttons that ask before they act. The question takes the place of the panel's controls, so it covers
// nothing else: what will happen in words, sometimes a text to type, one button that acts, and Cancel, which has the
// focus if there is nothing to type. The question closes when the station has accepted, on Cancel, and when the
// operator leaves the panel. A refusal stays with its reason.
namespace boresight::ui {

class CommandButton;
class RequestDesk;
class ValueLabel;

struct Question
{
    QString title;
    QString text;
    QString act;  // the text of the button that acts
    Request request;
    std::optional<Action> action = {};  // the action of the station, which may not be permitted any more
    // In place of the request, for an action that is not for the station. It receives the typed text.
    std::function<void(const QString&)> perform = {};
    QString typedName = {};  // the name of the input field; empty: there is none
    QString typed = {};      // the initial text of the field
};

class AskingPanel : public QStackedWidget
{
    Q_OBJECT

public:
    AskingPanel(RequestDesk& desk, QWidget* parent);

    [[nodiscard]] bool isAsking() const { return currentIndex() == 1; }
    void cancel() { closeQuestion(); }  // Esc

protected:
    [[nodiscard]] QWidget& controls() { return *m_controls; }
    void askFirst(const Question& question, const StationStatus& status);
    void showWhetherPossible(const StationStatus& status);
    void hideEvent(QHideEvent* event) override;

private:
    QWidget* makeQuestionPage();
    void carryOut();
    void closeQuestion();

    Question m_question;
    QWidget* m_controls;
    QLabel* m_title;
    QPlainTextEdit* m_text;
    QLabel* m_typedName;
    QLineEdit* m_typed;
    ValueLabel* m_notice;
    CommandButton* m_act;
    QPushButton* m_cancel;
    QWidget* m_asker = nullptr;  // had the focus before, and receives it back
};

}  // namespace boresight::ui
