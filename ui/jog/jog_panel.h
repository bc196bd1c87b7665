// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/messages/station_status.h"
#include "ui/hold/jog_pad.h"
#include "ui/jog/gamepad_pilot.h"

#include <QStringList>
#include <QWidget>

class QPushButton;

// The operator's own motion: the jog pad with its rate and steps, a gamepad, go to a direction or a preset, horizon,
// home, park. Typing and selecting move nothing. A refusal is shown below the pad.
// More than 15 members: the controls that it composes.
namespace boresight::ui {

class CommandButton;
class GoToBar;
class JogChoices;
class PresetBar;
class ProfileDraft;
class RequestDesk;
class ValueLabel;

class JogPanel : public QWidget
{
    Q_OBJECT

public:
    JogPanel(const Clock& clock, ProfileDraft& draft, RequestDesk& desk, const QStringList& recentGoTos,
             QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);
    void focusGoTo();  // Ctrl+G
    void park();       // Ctrl+P
    void hold();       // Ctrl+H
    void beat();       // a few times a second

    void takeGamepad(const GamepadSample& sample);
    void showGamepad(const QString& name);  // plugged in; empty: gone

    [[nodiscard]] JogPad& pad() { return *m_pad; }

Q_SIGNALS:
    void recentGoTosChanged(const QStringList& recent);
    void stopPressed();  // on the gamepad

private:
    void build();
    [[nodiscard]] QWidget* makeChoices();
    [[nodiscard]] QWidget* makePlaces();
    void fillRare();
    void showPark();
    void showTrim();
    void parkOrUnpark();

    ValueLabel* m_notice;
    JogPad* m_pad;
    JogChoices* m_choices;
    GoToBar* m_goTo;
    PresetBar* m_presets;
    CommandButton* m_horizon;
    CommandButton* m_home;
    CommandButton* m_park;
    ValueLabel* m_trim;
    CommandButton* m_clearTrim;
    CommandButton* m_unwrap;
    QPushButton* m_more;
    QWidget* m_rare;
    GamepadPilot m_pilot;
    StationStatus m_status;
};

}  // namespace boresight::ui
