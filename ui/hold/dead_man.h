// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/permissions.h"
#include "core/messages/request.h"

#include <QObject>
#include <QTimer>

#include <set>

// The dead-man switch of jogging. While at least one direction is pressed it repeats the request every kJogRepeat, and
// it sends "zero" once when the last one is released. If this program hangs the repeats stop, and the station stops the
// axes. Gui thread.
namespace boresight::ui {

class DeadMan : public QObject
{
    Q_OBJECT

public:
    explicit DeadMan(QObject* parent = nullptr);

    void setRate(AngularRate rate);  // applies from the next repeat on
    void hold(JogDirection direction);
    void letGo(JogDirection direction);
    // For keys: releases the direction unless it is pressed again within kKeyBounce. An X server repeats a pressed key
    // as pairs of release and press. Qt detects this only if both have arrived, and the motion must not stutter.
    void letGoSoon(JogDirection direction);
    void letGoAll();
    // For a stick: the part of the rate for each axis, -1 … 1. Both 0: released.
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
    std::set<JogDirection> m_released;  // still active until the key bounce is over
    double m_stickAzimuth = 0.0;
    double m_stickElevation = 0.0;
    AngularRate m_rate;
    QTimer m_repeat{this};
    QTimer m_bounce{this};
};

}  // namespace boresight::ui
