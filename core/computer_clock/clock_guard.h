// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_board.h"
#include "core/alarms/event_log.h"
#include "core/base/kept_clock.h"
#include "core/base/result.h"
#include "core/base/sleep_watch.h"
#include "core/computer_clock/time_effect.h"
#include "core/messages/station_status.h"

#include <functional>

// Watches the clock of this computer. Reports the error of the clock, and alarms when the clock was set or the computer
// slept. Decides when a clock that was set points the mount. If nothing depends on the time, the new time
// counts at once. A new time that a time source confirms counts at once if the old time was never confirmed. Otherwise
// it counts when no target is tracked by the time. The operator may use a new time at any moment. Station thread only.
namespace boresight {

class ClockGuard
{
public:
    // What a clock that was set by this time would change for the mount.
    using Effect = std::function<TimeEffect(Seconds)>;

    // All arguments outlive this.
    ClockGuard(KeptClock& clock, EventLog& log, AlarmBoard& alarms, Effect effect);

    // Call once per tick. True: the clock of this computer was set since the last call.
    [[nodiscard]] bool tick();
    [[nodiscard]] Result<> useNewTime(const Source& by);
    [[nodiscard]] const ClockStatus& status() const { return m_status; }

private:
    void noticeSleep();
    [[nodiscard]] bool noticeStep(bool due);
    void judge(Seconds ahead);
    void keep(Seconds ahead, const QString& shift);
    void follow();

    KeptClock& m_clock;
    EventLog& m_log;
    AlarmBoard& m_alarms;
    Effect m_effect;
    SleepWatch m_sleep;
    ClockStatus m_status;
    bool m_wasConfirmed = false;  // the time in use, by a time source
    std::optional<SteadyTime> m_asked;
};

}  // namespace boresight
