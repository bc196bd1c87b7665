// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QString>

#include <optional>
#include <vector>

// The alarms of the station, one per cause. An alarm stays until its cause is gone and, above an advisory, somebody
// has acknowledged it. What gets worse, or turns into something else, is a new alarm. Station thread only.
namespace boresight {

// What the operator reads: what happened, what Boresight did, what to do.
struct AlarmText
{
    QString what;
    QString action;
    QString remedy;
    QString brief = {};    // of what happened, after the name of the cause in the log; empty: as it is
    bool symptom = false;  // what else lasts and is as bad is more likely the cause, and is shown first
};

class AlarmList
{
public:
    // Raises the alarm named `cause`. True if it was not active before, or is worse or another now: worth a log line.
    bool raise(const QString& cause, Severity severity, const AlarmText& text, UtcTime now);
    // The cause is gone. True if it was active.
    bool clear(const QString& cause);
    void acknowledgeAll();
    void acknowledge(std::uint64_t id);  // one that is gone already stays gone

    [[nodiscard]] bool active(const QString& cause) const;
    // What lasts before what is over; then the worst first; among equals what was not seen, then causes before
    // symptoms, then the oldest.
    [[nodiscard]] std::vector<Alarm> list() const;

private:
    struct Entry
    {
        QString cause;
        Alarm alarm;
        bool symptom = false;
    };

    [[nodiscard]] std::vector<Entry>::iterator find(const QString& cause);
    void forgetFinished();

    std::vector<Entry> m_entries;
    std::uint64_t m_nextId = 1;
};

}  // namespace boresight
