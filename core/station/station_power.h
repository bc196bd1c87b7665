// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/log_throttle.h"
#include "core/messages/power_line_status.h"
#include "core/power/threaded_line.h"
#include "core/profile/in_force.h"

#include <QObject>

#include <memory>

// The line of the received power as the station uses it: the one that the profile names, opened and closed as the
// profile changes; its troubles go to the log. Station thread; the line itself is served by a thread of its own.
namespace boresight {

class StationPower : public QObject
{
    Q_OBJECT

public:
    // Profile, clock and log outlive this; any thread may read the clock.
    StationPower(const profile::InForce& profile, const Clock& clock, EventLog& log, QObject* parent);

    void open();
    void close();
    // A line that did not change goes on.
    void profileChanged(const profile::Profile& before, const profile::Profile& after);
    // How the line does now. Once per tick.
    PowerLineStatus tick();

Q_SIGNALS:
    void received(const boresight::power::Value& value);

private:
    const profile::InForce& m_profile;
    const Clock& m_clock;
    LogThrottle m_lines;
    std::unique_ptr<power::ThreadedLine> m_line;  // null: the profile names none, or it is closed
    QString m_problem;                            // reported last
    bool m_open = false;
};

}  // namespace boresight
