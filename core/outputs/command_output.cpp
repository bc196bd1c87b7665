// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/outputs/command_output.h"

namespace boresight::outputs {
CommandOutput::CommandOutput(const QString& program, const QStringList& arguments, const programs::Limits& limits,
                             QObject* parent)
    : Output(parent),
      m_program(program),
      m_arguments(arguments),
      m_limits(limits),
      m_on(makeSide(true)),
      m_off(makeSide(false))
{}

CommandOutput::Side CommandOutput::makeSide(bool on)
{
    Side side{.runner = std::make_unique<programs::ProgramRunner>(m_limits)};
    connect(side.runner.get(), &programs::ProgramRunner::ended, this,
            [this, on](const programs::Ending& ending) { finish(on, ending); });
    return side;
}

// Runs "off" once more if an "on" run went on beside it, because that run may have taken effect after "off".
CommandOutput::~CommandOutput()
{
    m_on.runner.reset();
    if ((m_on.runs || m_onEndedWithin) && !m_wanted) {
        m_off.runner = std::make_unique<programs::ProgramRunner>(m_limits);
        start(false);
    }
}

void CommandOutput::set(bool on)
{
    m_wanted = on;
    if (m_reached == on && !m_on.runs && !m_off.runs) {
        Q_EMIT reached(on);
    } else {
        step();
    }
}

void CommandOutput::start(bool on)
{
    Side& side = on ? m_on : m_off;
    side.runs = true;
    side.runner->run({.path = m_program,
                      .arguments = m_arguments + QStringList{on ? QStringLiteral("on") : QStringLiteral("off")},
                      .environment = {}});
}

void CommandOutput::step()
{
    const bool waits = m_wanted ? m_on.runs || m_off.runs : m_off.runs;
    if (!waits && m_reached != m_wanted) {
        start(m_wanted);
    }
}

void CommandOutput::finish(bool on, const programs::Ending& ending)
{
    (on ? m_on : m_off).runs = false;
    // "on" and "off" ran at the same time, so either may have come last.
    const bool isOverwritten = on ? m_off.runs : m_onEndedWithin;
    m_onEndedWithin = on && m_off.runs;
    // If this run is not for the wanted state, it may have overwritten that state. So the state is unknown.
    m_reached = ending.good && on == m_wanted && !isOverwritten ? std::optional(on) : std::nullopt;
    if (!ending.good) {
        Q_EMIT failed(ending.text);
    } else if (m_reached) {
        Q_EMIT reached(on);
    }
    if (on != m_wanted || isOverwritten) {
        step();
    }
}

}  // namespace boresight::outputs

#include "moc_command_output.cpp"
