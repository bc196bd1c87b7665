// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/programs/running_program.h"

#include <QObject>

#include <memory>
#include <vector>

// The part of ProgramRunner on the other thread: the running programs.
namespace boresight::programs {

class ProgramWorker final : public QObject
{
    Q_OBJECT

public:
    explicit ProgramWorker(const Limits& limits) : m_limits(limits) {}
    ~ProgramWorker() override;  // running programs get Limits::patience to end

    void start(const Job& job);

Q_SIGNALS:
    void ended(const boresight::programs::Ending& ending);

private:
    void finish(const RunningProgram* program, const Ending& ending);

    Limits m_limits;
    std::vector<std::unique_ptr<RunningProgram>> m_running;
};

}  // namespace boresight::programs
