// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/programs/program_worker.h"

#include "core/base/text.h"

#include <algorithm>

namespace boresight::programs {

ProgramWorker::~ProgramWorker()
{
    const QDeadlineTimer deadline(m_limits.patience);
    for (const auto& program : m_running) {
        program->waitUntil(deadline);
    }
}

void ProgramWorker::start(const Job& job)
{
    if (m_running.size() >= static_cast<std::size_t>(m_limits.most)) {
        Q_EMIT ended(
            {.text = Text::tr("%1 was not started: %2 programs run already").arg(job.path).arg(m_limits.most)});
        return;
    }
    RunningProgram* const program = m_running.emplace_back(std::make_unique<RunningProgram>(job, m_limits)).get();
    connect(program, &RunningProgram::ended, this, [this, program](const Ending& ending) { finish(program, ending); });
    program->start();
}

// The program leaves the list before its end is told, because the receiver may start the next one at once.
void ProgramWorker::finish(const RunningProgram* program, const Ending& ending)
{
    const auto found = std::ranges::find(m_running, program, &std::unique_ptr<RunningProgram>::get);
    found->release()->deleteLater();  // it still runs its own signal
    m_running.erase(found);
    Q_EMIT ended(ending);
}

}  // namespace boresight::programs

#include "moc_program_worker.cpp"
