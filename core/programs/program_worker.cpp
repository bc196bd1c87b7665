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
    connect(program, &RunningProgram::ended, this, [this, program](const Ending& ending) {
        Q_EMIT ended(ending);
        // The program object still runs its own signal, so it is deleted later.
        QMetaObject::invokeMethod(
            this, [this, program] { forget(program); }, Qt::QueuedConnection);
    });
    program->start();
}

void ProgramWorker::forget(const RunningProgram* program)
{
    std::erase_if(m_running, [program](const auto& one) { return one.get() == program; });
}

}  // namespace boresight::programs

#include "moc_program_worker.cpp"
