// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/messages/station_status.h"
#include "ui/hold/jog_pad.h"
#include "ui/jog/gamepad_pilot.h"

#include <QWidget>

// Manual motion by the operator: the jog pad with its rate and steps, a gamepad, the trim of a tracked target, the axis
// beside the two. A refusal is shown below the pad. Gui thread.
namespace boresight::ui {

class CommandButton;
class JogChoices;
class ProfileDraft;
class RequestDesk;
class ThirdAxisRow;
class ValueLabel;

class JogPanel : public QWidget
{
    Q_OBJECT

public:
    JogPanel(const Clock& clock, const ProfileDraft& draft, RequestDesk& desk, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);
    void hold();  // Ctrl+H
    void beat();  // called a few times a second

    void takeGamepad(const GamepadSample& sample);
    void showGamepad(const QString& name);  // plugged in; empty: unplugged

    [[nodiscard]] JogPad& pad() { return *m_pad; }

Q_SIGNALS:
    void stopPressed();  // on the gamepad

private:
    void build();
    [[nodiscard]] QWidget* makeChoices();
    void showTrim();

    ValueLabel* m_notice;
    JogPad* m_pad;
    JogChoices* m_choices;
    ValueLabel* m_trim;
    CommandButton* m_clearTrim;
    ThirdAxisRow* m_thirdAxis;
    GamepadPilot m_pilot;
    StationStatus m_status;
};

}  // namespace boresight::ui
