// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/kit/press_guard.h"

#include <QWidget>

#include <optional>

class QPushButton;

// The most important alarm with its complete text: what happened in bold, what Boresight did, what to do, and the one
// button that helps. Beside it the way back from a STOP or a fault, Acknowledge, and the number of alarms. A click on
// the text opens its line in the log. The card is shown only while there is an alarm, a latched STOP, or something to
// report. The symbol of an alarm that is not yet acknowledged flashes at 1 Hz, its text never does. Gui thread.
// More than 15 members: the widgets that it composes.
namespace boresight::ui {

class CommandButton;
class ProfileDraft;
class RequestDesk;
class ValueLabel;

// The form of the two sentences "what Boresight did" and "what to do", by the available room.
enum class AlarmForm
{
    Lines,    // one line each
    Flowing,  // one paragraph
    Remedy    // only what to do; the button More opens the whole text
};

class AlarmCard : public QWidget
{
    Q_OBJECT

public:
    AlarmCard(const ProfileDraft& draft, RequestDesk& desk, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);
    void beat(SteadyTime now, bool flashing);
    // Shows a text for some seconds in the place of a refusal.
    void sayForAWhile(const QString& what, SteadyTime now);
    void acknowledge();  // F8
    // For a low window or a long text: smaller letters for what happened, and less space around the text. No text is
    // left out.
    void setTight(bool tight);
    void setForm(AlarmForm form);
    [[nodiscard]] QString wholeText() const;  // whatever the form; empty: there is no alarm
    [[nodiscard]] int heightWith(AlarmForm form, int width) const;

    // For refusals of controls without their own notice line (STOP).
    [[nodiscard]] ValueLabel& notice() { return *m_notice; }

    bool eventFilter(QObject* watched, QEvent* event) override;

Q_SIGNALS:
    void lineWanted(const boresight::Alarm& alarm);  // the line of this alarm in the log
    void listWanted();                               // the list of all alarms
    void panelWanted(boresight::AlarmHelp help);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;

private:
    struct Said
    {
        QString what;
        SteadyTime at;
    };

    void build();
    void showAlarm(const StationStatus& status);
    void showButtons(const StationStatus& status);
    void showCount(const StationStatus& status);
    void showTimeOrMore();
    [[nodiscard]] QString adviceIn(AlarmForm form) const;
    void showWhetherNeeded();
    void help(AlarmHelp help, CommandButton& button);

    const ProfileDraft& m_draft;
    ValueLabel* m_what;
    ValueLabel* m_advice;
    ValueLabel* m_notice;
    ValueLabel* m_since;
    CommandButton* m_help;
    CommandButton* m_alternative;  // the other choice beside m_help, where there are two
    CommandButton* m_recover;
    CommandButton* m_acknowledge;
    QPushButton* m_count;
    QPushButton* m_more;
    std::optional<Alarm> m_shown;
    QString m_unwrapCost;  // what the choices at the cable end lose
    QString m_holdCost;
    AlarmForm m_form = AlarmForm::Lines;
    AlarmHelp m_recovery = AlarmHelp::None;
    AlarmHelp m_offered = AlarmHelp::None;  // by m_help
    PressGuard m_guard{this};               // after a button has taken the place of another one
    bool m_flashing = false;
    bool m_symbolShown = true;
    std::optional<Said> m_said;
};

}  // namespace boresight::ui
