// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/programs/running_program.h"

#include "core/base/control_characters.h"
#include "core/base/text.h"

#include <QProcessEnvironment>

#include <unistd.h>

#include <csignal>

namespace boresight::programs {
namespace {

constexpr qsizetype kMostErrors = 200;  // bytes

}  // namespace

RunningProgram::RunningProgram(const Job& job, const Limits& limits) : m_limits(limits)
{
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const auto& [name, value] : job.environment) {
        environment.insert(name, value);
    }
    m_process.setProgram(job.path);
    m_process.setArguments(job.arguments);
    m_process.setProcessEnvironment(environment);
    m_process.setStandardInputFile(QProcess::nullDevice());
    m_process.setStandardOutputFile(QProcess::nullDevice());
    m_process.setChildProcessModifier([] { ::setpgid(0, 0); });
    m_limit.setSingleShot(true);
    connect(&m_limit, &QTimer::timeout, this, &RunningProgram::limitReached);
    connect(&m_process, &QProcess::started, this, [this] { m_group = m_process.processId(); });
    connect(&m_process, &QProcess::readyReadStandardError, this, &RunningProgram::keepErrors);
    connect(&m_process, &QProcess::finished, this, &RunningProgram::finish);
    connect(&m_process, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
        if (error == QProcess::FailedToStart) {
            m_limit.stop();
            // The text is for instance "execve: No such file or directory".
            Q_EMIT ended({.text = line(Text::tr("could not be started: %1")
                                           .arg(m_process.errorString().section(QStringLiteral(": "), -1)))});
        }
    });
    m_time.start();
    m_limit.start(m_limits.longest);
}

RunningProgram::~RunningProgram()
{
    m_process.disconnect(this);
    if (m_process.state() != QProcess::NotRunning) {
        signalAll(SIGKILL);
        m_process.waitForFinished();
    }
}

void RunningProgram::waitUntil(QDeadlineTimer deadline)
{
    m_process.disconnect(this);
    m_process.waitForFinished(static_cast<int>(deadline.remainingTime()));
}

// Everything is read, so that the program never waits. Only the beginning is kept.
void RunningProgram::keepErrors()
{
    const QByteArray read = m_process.readAllStandardError();
    m_errors += read.left(kMostErrors - m_errors.size());
}

void RunningProgram::limitReached()
{
    signalAll(m_late ? SIGKILL : SIGTERM);
    m_late = true;
    m_limit.start(m_limits.patience);
}

void RunningProgram::signalAll(int signal) const
{
    if (m_group > 0) {
        ::kill(static_cast<pid_t>(-m_group), signal);
    }
}

void RunningProgram::finish(int status, QProcess::ExitStatus how)
{
    m_limit.stop();
    keepErrors();
    if (m_late) {
        signalAll(SIGKILL);  // ends programs that it has started and left running
    }
    const double took = static_cast<double>(m_time.elapsed()) / 1000.0;
    QString what = Text::tr("ended after %1 s").arg(took, 0, 'f', 1);
    if (m_late) {
        what = Text::tr("was ended after %1 s, the longest time for a program")
                   .arg(std::chrono::duration<double>(m_limits.longest).count());
    } else if (how == QProcess::CrashExit) {
        what = Text::tr("crashed after %1 s").arg(took, 0, 'f', 1);
    } else if (status != 0) {
        what = Text::tr("ended with status %1 after %2 s").arg(status).arg(took, 0, 'f', 1);
    }
    Q_EMIT ended({.good = !m_late && how == QProcess::NormalExit && status == 0, .text = line(what)});
}

QString RunningProgram::line(const QString& what) const
{
    const QString said = QString::fromUtf8(m_errors).trimmed().section(QLatin1Char('\n'), 0, 0);
    return m_process.program() + QLatin1Char(' ') + what +
           (said.isEmpty() ? QString() : QStringLiteral(": ") + printable(said));
}

}  // namespace boresight::programs

#include "moc_running_program.cpp"
