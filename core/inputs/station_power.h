// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/log_throttle.h"
#include "core/messages/power_line_status.h"
#include "core/power/threaded_line.h"
#include "core/profile/in_force.h"

#include <QObject>

#include <memory>

// The line of the received power that the profile names. It is opened and closed when the profile changes. Problems of
// the line go to the log. Station thread; a thread of its own serves the line.
namespace boresight {

class StationPower : public QObject
{
    Q_OBJECT

public:
    // Profile, clock and log outlive this. Any thread may read the clock.
    StationPower(const profile::InForce& profile, const Clock& clock, EventLog& log, QObject* parent);

    void open();
    void close();
    // A line that did not change stays open.
    void profileChanged(const profile::Profile& before, const profile::Profile& after);
    // Returns the state of the line. Call once per tick.
    PowerLineStatus tick();

Q_SIGNALS:
    void received(const boresight::power::Value& value);

private:
    const profile::InForce& m_profile;
    const Clock& m_clock;
    LogThrottle m_lines;
    std::unique_ptr<power::ThreadedLine> m_line;  // null: the profile names no line, or the line is closed
    QString m_problem;                            // the last one that was logged
    bool m_open = false;
};

}  // namespace boresight
