// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_entry.h"
#include "core/messages/station_status.h"

#include <QStringList>

#include <optional>
#include <tuple>
#include <vector>

// The alarms of the station, one in each place of the catalogue and about each thing. An alarm stays until its cause is
// gone and, above an advisory, somebody has acknowledged it. What gets worse, or turns into something else, is a new
// alarm. Station thread only.
namespace boresight {

class AlarmList
{
public:
    // The sentences of the alarm if it was not active before, or is worse or another now: worth a log line.
    std::optional<AlarmText> raise(const AlarmKey& key, Severity severity, const QStringList& arguments, UtcTime now);
    // The cause is gone. True if an alarm was active in this place.
    bool clear(const AlarmKey& key);
    void acknowledgeAll();
    void acknowledge(std::uint64_t id);  // one that is gone already stays gone

    [[nodiscard]] bool active(const AlarmKey& key) const;  // in this place
    // What lasts before what is over; then the worst first; among equals what was not seen, then causes before
    // symptoms, then the oldest. What explains others that stand comes before them, whatever its own severity.
    [[nodiscard]] std::vector<Alarm> list() const;

private:
    struct Entry
    {
        AlarmKey key;
        QStringList named;  // the arguments that what happened names
        Alarm alarm;
    };

    using Urgency = std::tuple<bool, int, bool>;  // less comes first

    [[nodiscard]] std::vector<Entry>::iterator find(const AlarmKey& key);
    [[nodiscard]] bool goesWithoutSaying(const Entry& entry) const;
    [[nodiscard]] Urgency urgencyOf(const Entry& entry) const;
    void forgetFinished();

    std::vector<Entry> m_entries;
    std::uint64_t m_nextId = 1;
};

}  // namespace boresight
