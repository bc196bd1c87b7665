// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/recognise/recognise.h"

#include <QFuture>

#include <optional>

// Collects the points of one client and finds the target that it tracks. Another thread computes this, on copies,
// because it takes longer than a tick. Station thread only.
namespace boresight::sources {

class ClientRecognition
{
public:
    void add(const recognise::SentPoint& point, SteadyTime now);
    // Without any point. A result that is still computed does not arrive.
    void clear();
    // A client that does not move its point waits for a rise only if it still reads the position or repeats the point.
    void setSeen(SteadyTime now) { m_seen = now; }

    // Begins to compute when there is something new.
    void step(const recognise::Sky& sky, SteadyTime now);
    // True once, when a result has arrived.
    [[nodiscard]] bool hasArrived();
    [[nodiscard]] const recognise::Recognition& found() const { return m_found; }

private:
    [[nodiscard]] bool isDue(SteadyTime now) const;

    recognise::SentPoints m_points;  // the newest ones that are apart
    SteadyTime m_began{};            // of the points
    SteadyTime m_seen{};             // when the client sent its last point, or read the position
    SteadyTime m_asked{};            // when it was computed last
    int m_tries = 0;
    bool m_isNew = false;  // a point came since then
    QFuture<recognise::Recognition> m_future;
    recognise::Recognition m_found;
};

}  // namespace boresight::sources
