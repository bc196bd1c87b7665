// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/night/report_keeper.h"

#include "core/base/text.h"

#include <utility>

namespace boresight {
namespace {

// Empty if nothing was measured.
QString errorOf(const schedule::PassRecord& record)
{
    if (record.rmsError && record.peakError) {
        return QLatin1Char(' ') + Text::tr("Error: %1° rms. Largest error: %2°.")
                                      .arg(record.rmsError->degrees(), 0, 'f', 3)
                                      .arg(record.peakError->degrees(), 0, 'f', 3);
    }
    return record.tracked > Seconds(0.0) ? QLatin1Char(' ') + Text::tr("The beam was never on target.") : QString();
}

}  // namespace

ReportKeeper::ReportKeeper(ReportFile& file, const Clock& clock, EventLog& log, QString source)
    : m_file(file), m_clock(clock), m_log(log), m_source(std::move(source))
{
    const std::vector<schedule::PassRecord>& stored = m_file.report().passes;
    if (!stored.empty() && isTonight(stored.back())) {
        m_report = m_file.report();
    }
    if (const std::optional<schedule::PassRecord> lost = m_file.lostPass(); lost && isTonight(*lost)) {
        store(*lost);
        m_log.add(
            Severity::Warning, m_source,
            Text::tr(
                "The last pass before this start was a pass of %1. It was tracked for %2 s. It is in the night report.")
                .arg(lost->name)
                .arg(lost->tracked.count(), 0, 'f', 0));
    }
}

bool ReportKeeper::isTonight(const schedule::PassRecord& pass) const
{
    return std::chrono::abs(m_clock.utc() - pass.los) < kSameNight;
}

void ReportKeeper::goesOn(const schedule::PassRecord& record)
{
    const SteadyTime now = m_clock.now();
    if (!m_kept || now - *m_kept >= kKept) {
        m_kept = now;
        m_file.keepPass(record);
    }
}

void ReportKeeper::store(const schedule::PassRecord& record)
{
    m_file.keepPass(record);
    std::vector<schedule::PassRecord>& passes = m_report.passes;
    passes.push_back(record);
    if (passes.size() > kMostPasses) {
        passes.erase(passes.begin());
    }
    flush();
}

void ReportKeeper::keep(const schedule::PassRecord& record)
{
    store(record);
    const QString seconds = Text::tr("%1 was tracked for %2 s. Within 1 dB: %3 s. Within 3 dB: %4 s.")
                                .arg(record.name)
                                .arg(record.tracked.count(), 0, 'f', 0)
                                .arg(record.within1dB.count(), 0, 'f', 0)
                                .arg(record.within3dB.count(), 0, 'f', 0);
    m_log.add(Severity::Advisory, m_source, seconds + errorOf(record));
}

void ReportKeeper::count(schedule::PassEnd end)
{
    int& count = end == schedule::PassEnd::Manual ? m_report.interventions : m_report.faults;
    ++count;
}

void ReportKeeper::noteProblem()
{
    if (m_file.problem() != m_problem) {
        m_problem = m_file.problem();
        if (!m_problem.isEmpty()) {
            m_log.add(Severity::Warning, m_source, m_problem);
        }
    }
}

}  // namespace boresight
