// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"

#include <QObject>
#include <QTimer>

#include <array>

// The moment of a recording that is shown, and how it moves on. Gui thread.
namespace boresight::ui {

class ReplayPlayer : public QObject
{
    Q_OBJECT

public:
    static constexpr std::array kSpeeds{1, 2, 5, 10, 30, 60};

    // The clock measures the time between two pictures, and must outlive the player.
    ReplayPlayer(const Clock& clock, UtcTime begin, UtcTime end, QObject* parent = nullptr);

    [[nodiscard]] UtcTime begin() const { return m_begin; }
    [[nodiscard]] UtcTime end() const { return m_end; }
    [[nodiscard]] UtcTime moment() const { return m_moment; }
    [[nodiscard]] bool isPlaying() const { return m_timer.isActive(); }
    [[nodiscard]] int speed() const { return m_speed; }

    void play(bool on);           // at the end it begins again
    void jumpTo(UtcTime moment);  // within the recording
    void step(Seconds by) { jumpTo(m_moment + std::chrono::round<UtcTime::duration>(by)); }
    void setSpeed(int speed);
    void changeSpeed(int steps);  // to the next faster or slower one

Q_SIGNALS:
    void moved();    // another moment
    void changed();  // plays or pauses, or has another speed

private:
    void advance();

    const Clock& m_clock;
    UtcTime m_begin;
    UtcTime m_end;
    UtcTime m_moment;
    int m_speed = kSpeeds.front();
    SteadyTime m_advanced{};
    QTimer m_timer{this};
};

}  // namespace boresight::ui
