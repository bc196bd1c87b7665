// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/edge_thread.h"
#include "core/programs/job.h"

#include <QObject>

#include <memory>

// Runs programs of the operator on a thread of its own, so the thread of its owner never waits. Only the destructor
// waits: running programs get Limits::patience. No shell: arguments are passed as they are. The first program starts
// the thread. Neither the thread nor a program has more than normal priority.
namespace boresight::programs {

class ProgramWorker;

class ProgramRunner final : public QObject
{
    Q_OBJECT

public:
    explicit ProgramRunner(const Limits& limits, QObject* parent = nullptr);
    ~ProgramRunner() override;

    void run(const Job& job);

Q_SIGNALS:
    // Emitted once for each job.
    void ended(const boresight::programs::Ending& ending);

private:
    Limits m_limits;
    ProgramWorker* m_worker = nullptr;  // lives on m_thread and belongs to it
    std::unique_ptr<EdgeThread> m_thread;
};

}  // namespace boresight::programs
