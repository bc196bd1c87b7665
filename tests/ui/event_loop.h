// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QTest>

#include <functional>

// The work that a test leaves to the event loop of the window. No wait has a fixed length: each ends with its
// condition.
namespace boresight::ui {

inline constexpr int kPatienceMs = 60'000;  // only a failing test waits this long

// Runs until everything is laid out, drawn and deleted.
inline void settle()
{
    constexpr int kAnimatedMs = 2'000;  // an animation never ends

    for (int round = 0; round < 2; ++round) {  // a deletion may cause another layout
        QCoreApplication::processEvents(QEventLoop::AllEvents, kAnimatedMs);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
}

// For the results of a thread or a file dialog.
[[nodiscard]] inline bool comesTrue(const std::function<bool()>& condition)
{
    return QTest::qWaitFor(condition, kPatienceMs);
}

[[nodiscard]] inline bool becomesActive(QWidget& window)
{
    return QTest::qWaitForWindowActive(&window, kPatienceMs);
}

}  // namespace boresight::ui
