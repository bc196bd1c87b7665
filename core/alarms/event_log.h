// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/messages/station_status.h"

#include <QString>

#include <deque>
#include <vector>

// The event log of the station: who requested what, why the mount moved, what went wrong. Keeps the newest kCapacity
// entries in memory. Each entry also goes to Qt's log category "boresight.station", so that the service prints it. The
// log of a rehearsal does not. Station thread only.
namespace boresight {

// A line for files, without the time: "azimuth drive [drive.silent]: The azimuth drive does not reply. …"
[[nodiscard]] QString plainLine(const LogEntry& entry);

class EventLog
{
public:
    static constexpr std::size_t kCapacity = 2000;

    enum class Echo
    {
        No,
        Yes  // also prints to Qt's log
    };

    explicit EventLog(const Clock& clock, Echo echo = Echo::Yes) : m_clock(clock), m_echo(echo) {}

    void add(Severity severity, const QString& source, const QString& text, LogKind kind = LogKind::Event,
             const LoggedAlarm& alarm = {});

    // The entries with numbers above `number`, oldest first: at most the newest `limit` of them.
    [[nodiscard]] std::vector<LogEntry> since(std::uint64_t number, std::size_t limit) const;
    [[nodiscard]] std::uint64_t lastNumber() const { return m_lastNumber; }

private:
    const Clock& m_clock;
    Echo m_echo;
    std::deque<LogEntry> m_entries;
    std::uint64_t m_lastNumber = 0;
};

}  // namespace boresight
