// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_entry.h"
#include "core/messages/station_status.h"

#include <QStringList>

#include <optional>
#include <tuple>
#include <vector>

// The alarms of the station, one for each place of the catalogue and each subject. An alarm stays until its cause is
// gone and, above an advisory, until it is acknowledged. An alarm that gets worse or turns into another one is a new
// alarm. Station thread only.
namespace boresight {

class AlarmList
{
public:
    // The sentences if the alarm was not active before, or is worse or different now. Then it needs a log line.
    std::optional<AlarmText> raise(const AlarmKey& key, Severity severity, const QStringList& arguments, UtcTime now);
    // The cause is gone. True if an alarm was active in this place.
    bool clear(const AlarmKey& key);
    void acknowledgeAll();
    void acknowledge(std::uint64_t id);  // does nothing if the alarm is gone

    [[nodiscard]] bool active(const AlarmKey& key) const;  // an alarm in this place
    // Active alarms first, then the higher severity. Among equals unacknowledged alarms first, then causes before
    // results, then the oldest. A cause comes before the active alarms that it explains, whatever its own severity.
    [[nodiscard]] std::vector<Alarm> list() const;

private:
    struct Entry
    {
        AlarmKey key;
        QStringList named;  // the arguments in the sentence about what happened
        Alarm alarm;
    };

    using Urgency = std::tuple<bool, int, bool>;  // the smaller value is more urgent

    [[nodiscard]] std::vector<Entry>::iterator find(const AlarmKey& key);
    [[nodiscard]] bool goesWithoutSaying(const Entry& entry) const;
    [[nodiscard]] Urgency urgencyOf(const Entry& entry) const;
    void forgetFinished();

    std::vector<Entry> m_entries;
    std::uint64_t m_nextId = 1;
};

}  // namespace boresight
