// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/permissions.h"
#include "core/messages/request.h"

#include <QObject>
#include <QTimer>

#include <set>

// The dead-man of jogging: while at least one direction is held it repeats the wish to move every kJogRepeat, and it
// says "zero" once when the last is let go. If this program hangs, the repeats stop and the station stops the axes.
// Gui thread.
namespace boresight::ui {

class DeadMan : public QObject
{
    Q_OBJECT

public:
    explicit DeadMan(QObject* parent = nullptr);

    void setRate(AngularRate rate);  // applies with the next repeat
    void hold(JogDirection direction);
    void letGo(JogDirection direction);
    // For keys: lets go unless the direction is held again within kKeyBounce. An X server repeats a held key as pairs
    // of release and press, and Qt sees through them only if both have arrived; they must not become a stutter.
    void letGoSoon(JogDirection direction);
    void letGoAll();
    // A stick: how much of the rate each axis shall have, -1 … 1. Both 0: let go.
    void steer(double azimuth, double elevation);

    [[nodiscard]] bool isHeld() const { return !m_held.empty() || isSteered(); }

Q_SIGNALS:
    void jog(const boresight::AxisRates& rates);

private:
    static constexpr std::chrono::milliseconds kKeyBounce{30};

    void repeat();
    void letGoReleased();
    [[nodiscard]] bool isSteered() const { return m_stickAzimuth != 0.0 || m_stickElevation != 0.0; }

    std::set<JogDirection> m_held;
    std::set<JogDirection> m_released;  // held still, until the key bounce is over
    double m_stickAzimuth = 0.0;
    double m_stickElevation = 0.0;
    AngularRate m_rate;
    QTimer m_repeat{this};
    QTimer m_bounce{this};
};

}  // namespace boresight::ui
