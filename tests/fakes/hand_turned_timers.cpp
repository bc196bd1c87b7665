// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fakes/hand_turned_timers.h"

#include <QCoreApplication>
#include <QTimerEvent>

#include <string_view>

namespace boresight::fakes {

HandTurnedTimers::HandTurnedTimers(QObject& root, ManualClock& clock) : m_root(root), m_clock(clock)
{
    QCoreApplication::instance()->installEventFilter(this);
}

void HandTurnedTimers::elapse(Seconds time)
{
    const SteadyTime end = m_clock.now() + std::chrono::duration_cast<SteadyTime::duration>(time);
    for (QTimer* first = look(); first != nullptr && m_due.at(first->timerId()) <= end; first = look()) {
        turnTo(m_due.at(first->timerId()));
        runOut(*first);
    }
    turnTo(end);
}

bool HandTurnedTimers::eventFilter(QObject* watched, QEvent* event)
{
    return event->type() == QEvent::Timer && watched != m_running && isTurned(*watched);
}

bool HandTurnedTimers::isTurned(const QObject& timer) const
{
    const QObject* above = timer.parent();
    if (qobject_cast<const QTimer*>(&timer) == nullptr || above == nullptr ||
        !std::string_view(above->metaObject()->className()).starts_with("boresight::")) {
        return false;
    }
    while (above != nullptr && above != &m_root) {
        above = above->parent();
    }
    return above != nullptr;
}

QTimer* HandTurnedTimers::look()
{
    std::map<int, SteadyTime> due;
    QTimer* first = nullptr;
    for (QTimer* const timer : m_root.findChildren<QTimer*>()) {
        if (!timer->isActive() || !isTurned(*timer)) {
            continue;
        }
        const auto known = m_due.find(timer->timerId());
        const SteadyTime at = known != m_due.end() ? known->second : m_clock.now() + timer->intervalAsDuration();
        due.emplace(timer->timerId(), at);
        if (first == nullptr || at < due.at(first->timerId())) {
            first = timer;
        }
    }
    m_due.swap(due);
    return first;
}

void HandTurnedTimers::runOut(QTimer& timer)
{
    m_due.at(timer.timerId()) = m_clock.now() + timer.intervalAsDuration();
    QTimerEvent event(timer.timerId());
    m_running = &timer;
    QCoreApplication::sendEvent(&timer, &event);
    m_running = nullptr;
}

void HandTurnedTimers::turnTo(SteadyTime then)
{
    if (then > m_clock.now()) {
        m_clock.advance(then - m_clock.now());
    }
}

}  // namespace boresight::fakes
