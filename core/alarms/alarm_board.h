// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_list.h"
#include "core/alarms/log_throttle.h"
#include "core/base/clock.h"

#include <QString>
#include <QStringList>

#include <map>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

// The alarms of the station and their lines in the log: one line when an alarm begins and one when it ends, however
// often its cause is reported. A flickering alarm is throttled; other alarms are not. If the beginning was written, the
// end is written, too. If the beginning was left out and the alarm is still active a second later, it is written then.
// Station thread only.
namespace boresight {

class AlarmBoard
{
public:
    AlarmBoard(EventLog& log, const Clock& clock);

    // `key` names an entry of the catalogue, which also gives the number of arguments.
    void raise(const AlarmKey& key, const QStringList& arguments = {});
    // `severity` is one of the entry's two severities.
    void raise(const AlarmKey& key, Severity severity, const QStringList& arguments);
    void clear(const AlarmKey& key);  // the active alarm in this place
    void tick();                      // in each tick of the station
    void acknowledgeAll() { m_alarms.acknowledgeAll(); }
    void acknowledge(std::uint64_t id) { m_alarms.acknowledge(id); }

    [[nodiscard]] bool active(const AlarmKey& key) const { return m_alarms.active(key); }
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
        QString source;
        QString what = {};       // happened, by the latest alarm
        LoggedAlarm alarm = {};  // the latest alarm
        LogThrottle throttle;
        bool told = false;                    // the beginning was written
        std::optional<LeftOut> leftOut = {};  // of the active alarm
    };

    [[nodiscard]] Lines& linesOf(const AlarmKey& key);

    EventLog& m_log;
    const Clock& m_clock;
    AlarmList m_alarms;
    std::map<std::pair<std::string_view, QString>, Lines> m_lines;  // by place and subject; there are only a few
};

}  // namespace boresight
