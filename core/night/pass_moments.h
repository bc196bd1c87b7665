// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/event_log.h"
#include "core/schedule/pass_moment.h"

#include <functional>
#include <optional>

// When the moments of the passes of an armed schedule have come. Each is told once, in order. What was told to come is
// told to end, whatever ends it. Station thread.
namespace boresight {

class PassMoments
{
public:
    using Tell = std::function<void(const schedule::PassMoment&)>;

    // Both outlive it. Without `tell` the moments are lines of the log only.
    PassMoments(EventLog& log, const Clock& clock, Tell tell);

    // The pass that comes next, in each tick between two passes. Null: none.
    void expect(const schedule::WatchedPass* next, Seconds before);
    // The mount tracks this pass, or waits for it. In each tick.
    void follow(const schedule::WatchedPass& pass, Seconds before);
    void end(schedule::PassEnd end, const QString& why);
    void fault(const QString& why);

private:
    void announce(const schedule::WatchedPass& pass);
    void tell(const schedule::PassMoment& moment) const;

    EventLog& m_log;
    const Clock& m_clock;
    Tell m_tell;
    std::optional<schedule::WatchedPass> m_pass;  // told to come
    bool m_begun = false;                         // its AOS was told
};

}  // namespace boresight
