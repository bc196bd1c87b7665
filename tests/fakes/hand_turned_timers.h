// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/fakes/manual_clock.h"

#include <QObject>
#include <QTimer>

#include <map>

// Runs the timers of Boresight's objects below `root` by a clock that is turned by hand. The time of this computer has
// no effect on them, so a test neither waits for them nor is surprised by them. Qt's own timers run normally. The time
// of a timer begins at the first look after its start. A timer that is restarted between two looks keeps the time of
// its first start. Gui thread, or the main thread of a program without a window.
namespace boresight::fakes {

class HandTurnedTimers : public QObject
{
public:
    HandTurnedTimers(QObject& root, ManualClock& clock);

    // Turns the clock. Each timer runs out at its own time, in order.
    void elapse(Seconds time);
    // Runs the timers that are due when somebody else has turned the clock.
    void runDue() { elapse(Seconds(0.0)); }

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    [[nodiscard]] bool isTurned(const QObject& timer) const;
    [[nodiscard]] QTimer* look();  // the timer that runs out first
    void runOut(QTimer& timer);
    void turnTo(SteadyTime then);

    QObject& m_root;
    ManualClock& m_clock;
    std::map<int, SteadyTime> m_due;  // by timer id
    const QObject* m_running = nullptr;
};

}  // namespace boresight::fakes
