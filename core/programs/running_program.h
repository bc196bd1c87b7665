// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/programs/job.h"

#include <QByteArray>
#include <QDeadlineTimer>
#include <QElapsedTimer>
#include <QObject>
#include <QProcess>
#include <QTimer>

// One program while it runs, in a process group of its own: what it has started ends with it at the time limit. What it
// prints is thrown away, but for the beginning of its errors. It is killed when this is destroyed.
namespace boresight::programs {

class RunningProgram final : public QObject
{
    Q_OBJECT

public:
    RunningProgram(const Job& job, const Limits& limits);
    ~RunningProgram() override;
    void start() { m_process.start(QIODevice::ReadOnly); }
    // Waits for it, at most until then. It is the last that is asked of it.
    void waitUntil(QDeadlineTimer deadline);

Q_SIGNALS:
    void ended(const boresight::programs::Ending& ending);  // the last word

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
    qint64 m_group = 0;  // 0: it has not begun
    bool m_late = false;
};

}  // namespace boresight::programs
