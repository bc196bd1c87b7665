// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/messages/station_status.h"
#include "ui/hold/dead_man.h"

#include <QWidget>

#include <map>
#include <optional>

// Four jog buttons around Hold. The arrow keys do the same once the pad is armed by a click on it (or by Enter while it
// has the focus). The armed pad has a frame. It disarms when it loses the focus or is not used for a minute. Shift jogs
// fast. Ctrl, or the step mode, moves one step instead. While a client's target is tracked a step trims it, and the
// client keeps control. The pad repeats the request while a button or key is pressed, and ends the motion on release,
// loss of focus, window switch, refusal, or when motion is no longer permitted.
namespace boresight::ui {

class CommandButton;
class JogButton;
class RequestDesk;
class ValueLabel;

class JogPad : public QWidget
{
    Q_OBJECT

public:
    JogPad(const Clock& clock, RequestDesk& desk, ValueLabel& notice, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);
    void setRate(AngularRate rate);  // while pressed, without Shift
    void setStep(Angle step);
    void setStepMode(bool on);
    void setNarrow();  // beside other controls: buttons as wide as a finger, caption in two lines
    // A stick with its dead-man switch pressed: the part of the rate for each axis, -1 … 1. Both 0: released.
    void steer(double azimuth, double elevation);
    void setGamepad(const QString& name);  // plugged in; empty: no gamepad
    void disarmWhenUnused();               // called a few times a second

    void hold();  // request::Hold

    [[nodiscard]] bool isArmed() const { return m_armedUntil.has_value(); }
    [[nodiscard]] JogButton& button(JogDirection direction) { return *m_buttons.at(direction); }

Q_SIGNALS:
    void interrupted();  // the press does not count any more: a new press is needed

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void build();
    void connectButton(JogDirection direction);
    void press(JogDirection direction, bool oneStep);
    void arm();
    void disarm();
    void letGoAll();
    void sendJog(const AxisRates& rates);
    void sendStep(JogDirection direction);
    void refused(const std::optional<Error>& error);
    void applyRate();
    void showCaption();
    void showHelp();

    const Clock& m_clock;
    RequestDesk& m_desk;
    ValueLabel& m_notice;
    std::map<JogDirection, JogButton*> m_buttons;
    CommandButton* m_hold;
    ValueLabel* m_caption;
    DeadMan m_deadMan{this};
    StationStatus m_status;
    AngularRate m_rate;
    Angle m_step;
    QString m_gamepad;
    bool m_stepMode = false;
    bool m_shift = false;
    std::optional<SteadyTime> m_armedUntil;
};

}  // namespace boresight::ui
