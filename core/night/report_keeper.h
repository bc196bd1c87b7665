// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/event_log.h"
#include "core/base/clock.h"
#include "core/night/report_file.h"
#include "core/schedule/night_report.h"

#include <QString>

#include <optional>

// Keeps the report of a night: continues the report of the previous run, adds each pass and writes a line of the log,
// and stores the present pass in case of a crash. Station thread.
namespace boresight {

class ReportKeeper
{
public:
    // A stored report is continued if its last pass ended within this time.
    static constexpr std::chrono::hours kSameNight{24};
    static constexpr std::size_t kMostPasses = 500;
    // A crash loses at most this time of a pass. A write has about 300 bytes, which is little for a flash card.
    static constexpr std::chrono::seconds kKept{30};

    // All arguments must outlive this object. `source` stands in the lines of the log.
    ReportKeeper(ReportFile& file, const Clock& clock, EventLog& log, QString source);

    [[nodiscard]] const schedule::NightReport& report() const { return m_report; }

    // The tracking of a pass begins, continues, and ends.
    void begun() { m_kept.reset(); }
    void goesOn(const schedule::PassRecord& record);
    void keep(const schedule::PassRecord& record);
    // The same without a line of the log.
    void store(const schedule::PassRecord& record);
    // Counts how the schedule was disarmed. The count is stored with the pass that this ended. Without a pass, call
    // flush().
    void count(schedule::PassEnd end);
    void flush() { m_file.keep(m_report); }
    // Writes each problem of the files to the log once.
    void noteProblem();

private:
    [[nodiscard]] bool isTonight(const schedule::PassRecord& pass) const;

    ReportFile& m_file;
    const Clock& m_clock;
    EventLog& m_log;
    QString m_source;
    schedule::NightReport m_report;
    std::optional<SteadyTime> m_kept = {};  // when the tracked pass was last stored
    QString m_problem;                      // already in the log
};

}  // namespace boresight
