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

// The alarms of the station and their lines in the log: each comes and goes with one line, however often its cause is
// named. One that flickers is throttled without a word of the others left out; what was told is also told to be over,
// and what still stands a second after its beginning was left out is told then. Station thread only.
namespace boresight {

class AlarmBoard
{
public:
    AlarmBoard(EventLog& log, const Clock& clock);

    // With an entry of the catalogue, which says how many arguments its sentences have.
    void raise(const AlarmKey& key, const QStringList& arguments = {});
    void raise(const AlarmKey& key, Severity severity, const QStringList& arguments);  // one of its two
    void clear(const AlarmKey& key);                                                   // whichever stands in its place
    void tick();                                                                       // each tick of the station
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
        LoggedAlarm alarm = {};  // that came last
        LogThrottle throttle;
        bool told = false;                    // that it began
        std::optional<LeftOut> leftOut = {};  // of what stands
    };

    [[nodiscard]] Lines& linesOf(const AlarmKey& key);

    EventLog& m_log;
    const Clock& m_clock;
    AlarmList m_alarms;
    std::map<std::pair<std::string_view, QString>, Lines> m_lines;  // by place and what they are about; these are few
};

}  // namespace boresight
