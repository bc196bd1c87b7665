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

    // Begins to compute when there is something new. Call it only while the client reads the position: a client that
    // sends one point and reads nothing does not wait for a rise.
    void step(const recognise::Sky& sky, SteadyTime now);
    // True once, when a result has arrived.
    [[nodiscard]] bool hasArrived();
    [[nodiscard]] const recognise::Recognition& found() const { return m_found; }

private:
    [[nodiscard]] bool waitsForRise(SteadyTime now) const;
    [[nodiscard]] bool hasNewMotion() const;
    [[nodiscard]] bool isMotionDue(SteadyTime now) const;
    [[nodiscard]] bool isRiseDue(SteadyTime now) const;
    void compute(const recognise::SentPoints& points, const recognise::Sky& sky);

    recognise::SentPoints m_points;                // the newest ones that are apart
    std::optional<recognise::SentPoint> m_newest;  // also if it is near the one before
    SteadyTime m_came{};                           // when the newest point came first
    bool m_isNew = false;                          // a point came since the motion was computed last
    int m_tries = 0;                               // of the motion
    SteadyTime m_tried{};                          // when the motion was computed last
    std::optional<SteadyTime> m_triedRise{};       // when the rise at the newest point was computed last
    QFuture<recognise::Recognition> m_future;
    recognise::Recognition m_found;
};

}  // namespace boresight::sources
