// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/fakes/manual_clock.h"

#include <QObject>
#include <QTimer>

#include <map>

// The timers of our objects below `root`, run by a clock that is turned by hand. This computer's time does nothing to
// them, so a test neither waits for them nor is surprised by them. Qt's own timers run on. A timer's time begins with
// the first look at it after its start. One that is started again between two looks keeps the time of its first start.
// Gui thread, and the main thread of a program without a window.
namespace boresight::fakes {

class HandTurnedTimers : public QObject
{
public:
    HandTurnedTimers(QObject& root, ManualClock& clock);

    // Turns the clock. Each timer runs out at its own time, in order.
    void elapse(Seconds time);
    // What the clock, turned by somebody else, has made due.
    void runDue() { elapse(Seconds(0.0)); }

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    [[nodiscard]] bool isTurned(const QObject& timer) const;
    [[nodiscard]] QTimer* look();  // the one that runs out first
    void runOut(QTimer& timer);
    void turnTo(SteadyTime then);

    QObject& m_root;
    ManualClock& m_clock;
    std::map<int, SteadyTime> m_due;  // by the timer's id
    const QObject* m_running = nullptr;
};

}  // namespace boresight::fakes
