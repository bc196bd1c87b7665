// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/hold/dead_man.h"

#include <algorithm>
#include <utility>

namespace boresight::ui {

DeadMan::DeadMan(QObject* parent) : QObject(parent)
{
    m_repeat.setInterval(kJogRepeat);
    m_repeat.setTimerType(Qt::PreciseTimer);  // a coarse timer may be 5 % late
    connect(&m_repeat, &QTimer::timeout, this, &DeadMan::repeat);
    m_bounce.setInterval(kKeyBounce);
    m_bounce.setTimerType(Qt::PreciseTimer);
    m_bounce.setSingleShot(true);
    connect(&m_bounce, &QTimer::timeout, this, &DeadMan::letGoReleased);
}

void DeadMan::setRate(AngularRate rate)
{
    m_rate = rate;
}

void DeadMan::hold(JogDirection direction)
{
    m_released.erase(direction);
    if (m_held.insert(direction).second) {
        repeat();
        m_repeat.start();
    }
}

void DeadMan::letGo(JogDirection direction)
{
    if (m_held.erase(direction) == 0) {
        return;
    }
    if (!isHeld()) {
        m_repeat.stop();
    }
    repeat();
}

void DeadMan::letGoSoon(JogDirection direction)
{
    if (m_held.contains(direction)) {
        m_released.insert(direction);
        m_bounce.start();
    }
}

void DeadMan::letGoReleased()
{
    for (const JogDirection direction : std::exchange(m_released, {})) {
        letGo(direction);
    }
}

void DeadMan::letGoAll()
{
    m_released.clear();
    if (isHeld()) {
        m_held.clear();
        m_stickAzimuth = m_stickElevation = 0.0;
        m_repeat.stop();
        repeat();
    }
}

void DeadMan::steer(double azimuth, double elevation)
{
    const bool was = isHeld();
    m_stickAzimuth = azimuth;
    m_stickElevation = elevation;
    if (isHeld() == was) {
        return;  // the next repeat uses it
    }
    repeat();
    isHeld() ? m_repeat.start() : m_repeat.stop();
}

void DeadMan::repeat()
{
    const auto part = [this](JogDirection plus, JogDirection minus, double stick) {
        const double keys = (m_held.contains(plus) ? 1.0 : 0.0) - (m_held.contains(minus) ? 1.0 : 0.0);
        return std::clamp(keys + stick, -1.0, 1.0);
    };
    Q_EMIT jog({.azimuth = m_rate * part(JogDirection::Right, JogDirection::Left, m_stickAzimuth),
                .elevation = m_rate * part(JogDirection::Up, JogDirection::Down, m_stickElevation)});
}

}  // namespace boresight::ui

#include "moc_dead_man.cpp"
