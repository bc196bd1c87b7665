// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractEventDispatcher>
#include <QEventLoop>
#include <QTimer>

#include <chrono>
#include <functional>

// Runs the event loop until `condition` holds. Checks it after each event and every 20 ms, because it may depend on
// another thread or program. The condition may run the event loop itself. Only a failing test reaches the limit, which
// leaves room for a computer that is twenty times slower than usual.
namespace boresight::fakes {

[[nodiscard]] inline bool waitUntil(const std::function<bool()>& condition,
                                    std::chrono::milliseconds limit = std::chrono::minutes(1))
{
    if (condition()) {
        return true;
    }
    QEventLoop loop;
    bool looking = false;
    bool met = false;
    const auto look = [&] {
        if (!looking && !met) {
            looking = true;
            met = condition();
            looking = false;
            if (met) {
                loop.quit();
            }
        }
    };
    QTimer::singleShot(limit, &loop, &QEventLoop::quit);
    QObject::connect(QAbstractEventDispatcher::instance(), &QAbstractEventDispatcher::aboutToBlock, &loop, look);
    QTimer again;
    QObject::connect(&again, &QTimer::timeout, look);
    again.start(std::chrono::milliseconds(20));
    loop.exec();
    return met || condition();
}

}  // namespace boresight::fakes
