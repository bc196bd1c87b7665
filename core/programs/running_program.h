// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/programs/job.h"

#include <QByteArray>
#include <QDeadlineTimer>
#include <QElapsedTimer>
#include <QObject>
#include <QProcess>
#include <QTimer>

// One running program in a process group of its own: at the time limit, the programs that it has started end with it.
// Its output is dropped, except for the beginning of its errors. The destructor kills it.
namespace boresight::programs {

class RunningProgram final : public QObject
{
    Q_OBJECT

public:
    RunningProgram(const Job& job, const Limits& limits);
    ~RunningProgram() override;
    void start() { m_process.start(QIODevice::ReadOnly); }
    // Waits until the program has ended, at most until `deadline`. No signal is emitted after this.
    void waitUntil(QDeadlineTimer deadline);

Q_SIGNALS:
    void ended(const boresight::programs::Ending& ending);  // the last signal

private:
    void keepErrors();
    void limitReached();
    void finish(int status, QProcess::ExitStatus how);
    void signalAll(int signal) const;
    [[nodiscard]] QString line(const QString& what) const;

    Limits m_limits;
    QProcess m_process;
    QTimer m_limit;
    QElapsedTimer m_time;
    QByteArray m_errors;
    qint64 m_group = 0;  // process group; 0: not started
    bool m_late = false;
};

}  // namespace boresight::programs
