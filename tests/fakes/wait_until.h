// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractEventDispatcher>
#include <QEventLoop>
#include <QTimer>

#include <chrono>
#include <functional>

// Runs the event loop until `condition` holds, looking at it after each event. No polling and no sleeping; the limit
// is only ever reached by a failing test, so it has room for a machine that is twenty times slower than usual.
namespace boresight::fakes {

[[nodiscard]] inline bool waitUntil(const std::function<bool()>& condition,
                                    std::chrono::milliseconds limit = std::chrono::minutes(1))
{
    if (condition()) {
        return true;
    }
    QEventLoop loop;
    QTimer::singleShot(limit, &loop, &QEventLoop::quit);
    QObject::connect(QAbstractEventDispatcher::instance(), &QAbstractEventDispatcher::aboutToBlock, &loop,
                     [&loop, &condition] {
                         if (condition()) {
                             loop.quit();
                         }
                     });
    loop.exec();
    return condition();
}

}  // namespace boresight::fakes
