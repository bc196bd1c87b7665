// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_list.h"
#include "core/alarms/log_throttle.h"
#include "core/base/clock.h"

#include <QString>

#include <map>
#include <optional>
#include <vector>

// The alarms of the station and their lines in the log: each comes and goes with one line, however often its cause is
// named. One that flickers is throttled without a word of the others left out; what was told is also told to be over,
// and what still stands a second after its beginning was left out is told then. Station thread only.
namespace boresight {

class AlarmBoard
{
public:
    AlarmBoard(EventLog& log, const Clock& clock);

    // `cause` names the alarm, and begins its log line.
    void raise(const QString& cause, Severity severity, const AlarmText& text);
    void clear(const QString& cause);
    void tick();  // each tick of the station
    void acknowledgeAll() { m_alarms.acknowledgeAll(); }
    void acknowledge(std::uint64_t id) { m_alarms.acknowledge(id); }

    [[nodiscard]] bool active(const QString& cause) const { return m_alarms.active(cause); }
    [[nodiscard]] std::vector<Alarm> list() const { return m_alarms.list(); }

private:
    struct LeftOut
    {
        Severity severity;
        QString text;
        SteadyTime since;
    };
    struct Lines
    {
        LogThrottle throttle;
        bool told = false;               // that it began
        std::optional<LeftOut> leftOut;  // of what stands
    };

    [[nodiscard]] Lines& linesOf(const QString& cause);

    EventLog& m_log;
    const Clock& m_clock;
    AlarmList m_alarms;
    std::map<QString, Lines> m_lines;  // by cause; the causes are the program's own, and few
};

}  // namespace boresight
