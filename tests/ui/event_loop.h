// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QTest>

#include <functional>

// What a test leaves to the event loop of the window. No wait has a fixed length: each ends with what it waits for.
namespace boresight::ui {

inline constexpr int kPatienceMs = 60'000;  // only a failing test needs as much

// Until nothing is left to do: laid out, drawn, deleted.
inline void settle()
{
    constexpr int kAnimatedMs = 2'000;  // what is animated is never done

    for (int round = 0; round < 2; ++round) {  // what is deleted may leave something to be laid out
        QCoreApplication::processEvents(QEventLoop::AllEvents, kAnimatedMs);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
}

// What a thread or a file dialog brings about.
[[nodiscard]] inline bool comesTrue(const std::function<bool()>& condition)
{
    return QTest::qWaitFor(condition, kPatienceMs);
}

[[nodiscard]] inline bool becomesActive(QWidget& window)
{
    return QTest::qWaitForWindowActive(&window, kPatienceMs);
}

}  // namespace boresight::ui
