// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_board.h"
#include "core/alarms/event_log.h"
#include "core/base/sleep_watch.h"
#include "core/messages/station_status.h"
#include "core/sources/steered_utc.h"

// Watches the clock of this computer. Reports the error of the clock, and alarms when the clock was set or the computer
// slept. Changes nothing. Station thread only.
namespace boresight {

class ClockGuard
{
public:
    // All arguments outlive this.
    ClockGuard(const Clock& clock, EventLog& log, AlarmBoard& alarms)
        : m_clock(clock), m_log(log), m_alarms(alarms), m_sleep(clock)
    {}

    // Call once per tick.
    void tick();
    [[nodiscard]] const ClockStatus& status() const { return m_status; }

private:
    void noticeSleep(Seconds slept);
    void noticeStep(Seconds step);

    const Clock& m_clock;
    EventLog& m_log;
    AlarmBoard& m_alarms;
    sources::SteeredUtc m_utc;
    SleepWatch m_sleep;
    ClockStatus m_status;
    std::optional<SteadyTime> m_asked;
};

}  // namespace boresight
