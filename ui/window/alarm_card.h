// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QWidget>

#include <optional>

class QPushButton;

// The alarm that matters most, whole: what happened in bold, what Boresight did, what to do, and the one button that
// helps. Beside it the way back from a STOP or a fault, Acknowledge, and how many alarms there are. A click on the text
// opens its line in the log. There only while there is an alarm, a latched STOP, or something to report. An alarm not
// yet acknowledged flashes its symbol at 1 Hz, never its text. Gui thread.
// More than 15 members: the widgets that it composes.
namespace boresight::ui {

class CommandButton;
class ProfileDraft;
class RequestDesk;
class ValueLabel;

// Of what Boresight did and what to do, by the room there is.
enum class AlarmForm
{
    Lines,    // a line each
    Flowing,  // one paragraph
    Remedy    // only what to do. The button More opens the whole text
};

class AlarmCard : public QWidget
{
    Q_OBJECT

public:
    AlarmCard(const ProfileDraft& draft, RequestDesk& desk, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);
    void beat(SteadyTime now, bool flashing);
    // In the place of a refusal, for some seconds.
    void sayForAWhile(const QString& what, SteadyTime now);
    void acknowledge();  // F8
    // For a low window: smaller letters for what happened, and less ground around the text. Nothing is left out.
    void setLow(bool low);
    void setForm(AlarmForm form);
    [[nodiscard]] int heightWith(AlarmForm form, int width) const;

    // For refusals of controls that have no line of their own (STOP).
    [[nodiscard]] ValueLabel& notice() { return *m_notice; }

    bool eventFilter(QObject* watched, QEvent* event) override;

Q_SIGNALS:
    void lineWanted(const boresight::Alarm& alarm);  // of the log
    void listWanted();                               // of all alarms
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
    QString m_cost;  // of the choices at the end of the cable
    AlarmForm m_form = AlarmForm::Lines;
    AlarmHelp m_recovery = AlarmHelp::None;
    bool m_flashing = false;
    bool m_symbolShown = true;
    std::optional<Said> m_said;
};

}  // namespace boresight::ui
