// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/event_log.h"
#include "core/base/clock.h"
#include "core/night/report_file.h"
#include "core/schedule/night_report.h"

#include <QString>

#include <optional>

// Keeps the report of a night: goes on with the one of the program before, takes each pass into it and writes a line of
// the log, and stores the pass that goes on against a crash. Station thread.
namespace boresight {

class ReportKeeper
{
public:
    // A stored report goes on if its last pass ended within this time.
    static constexpr std::chrono::hours kSameNight{24};
    static constexpr std::size_t kMostPasses = 500;
    // What a crash costs at most of a pass. A write takes some 300 bytes, which is little for a flash card.
    static constexpr std::chrono::seconds kKept{30};

    // All of them outlive the keeper. `source` stands in the lines of the log.
    ReportKeeper(ReportFile& file, const Clock& clock, EventLog& log, QString source);

    [[nodiscard]] const schedule::NightReport& report() const { return m_report; }

    // A pass begins to be tracked, goes on, and is over.
    void begun() { m_kept.reset(); }
    void goesOn(const schedule::PassRecord& record);
    void keep(const schedule::PassRecord& record);
    // The same without a line of the log.
    void store(const schedule::PassRecord& record);
    // The schedule was disarmed so. It is stored with the pass that this ended; without one, by flush().
    void count(schedule::PassEnd end);
    void flush() { m_file.keep(m_report); }
    // What is wrong with the files comes into the log, once for each problem.
    void noteProblem();

private:
    [[nodiscard]] bool isTonight(const schedule::PassRecord& pass) const;

    ReportFile& m_file;
    const Clock& m_clock;
    EventLog& m_log;
    QString m_source;
    schedule::NightReport m_report;
    std::optional<SteadyTime> m_kept = {};  // the tracked pass was, for a crash
    QString m_problem;                      // that the log has
};

}  // namespace boresight
