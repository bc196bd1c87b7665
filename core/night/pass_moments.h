// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/event_log.h"
#include "core/schedule/pass_moment.h"

#include <functional>
#include <optional>

// The moments of the passes of an armed schedule. Each is reported once, in order. Every pass that was reported to come
// is also reported to end, for whatever reason. Station thread.
namespace boresight {

class PassMoments
{
public:
    using Tell = std::function<void(const schedule::PassMoment&)>;

    // Log and clock must outlive this object. Without `tell` the moments are lines of the log only.
    PassMoments(EventLog& log, const Clock& clock, Tell tell);

    // Call it in each tick between two passes with the next pass. Null: none.
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
    std::optional<schedule::WatchedPass> m_pass;  // reported to come
    bool m_begun = false;                         // its AOS was reported
};

}  // namespace boresight
