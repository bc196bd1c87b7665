// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/programs/program_runner.h"

#include "core/programs/program_worker.h"

#include <utility>

namespace boresight::programs {

ProgramRunner::ProgramRunner(const Limits& limits, QObject* parent) : QObject(parent), m_limits(limits) {}

ProgramRunner::~ProgramRunner() = default;

void ProgramRunner::run(const Job& job)
{
    if (!m_thread) {
        auto worker = std::make_unique<ProgramWorker>(m_limits);
        m_worker = worker.get();
        connect(m_worker, &ProgramWorker::ended, this, &ProgramRunner::ended);
        m_thread = std::make_unique<EdgeThread>(QStringLiteral("programs"), std::move(worker));
    }
    m_thread->post([worker = m_worker, job] { worker->start(job); });
}

}  // namespace boresight::programs

#include "moc_program_runner.cpp"
