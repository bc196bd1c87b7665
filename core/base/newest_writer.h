// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <QObject>
#include <QString>
#include <QThreadPool>

#include <functional>
#include <memory>

// Writes files beside the thread on which it lives, and never makes that wait: one worker writes, and of the jobs that
// come in meanwhile the newest wins.
namespace boresight {

class NewestWriter final : public QObject
{
    Q_OBJECT

public:
    using Job = std::function<Result<>()>;  // touches nothing but its own copies

    explicit NewestWriter(QObject* parent = nullptr);
    ~NewestWriter() override;  // flushes

    void write(Job job);
    // Waits until the newest job is done, and returns how that went. Needs no event loop.
    Result<> flush();

Q_SIGNALS:
    // How each job that was begun has ended, from the event loop.
    void written();
    void failed(const QString& reason);
    void jobDone();  // from the worker, to this object

private:
    void start(Job job);
    void finish();

    std::shared_ptr<Result<>> m_outcome = std::make_shared<Result<>>();  // of the last job; the worker's until it ends
    Job m_next;                                                          // came in meanwhile; null: none
    bool m_writing = false;                                              // finish() is still to come
    QThreadPool m_worker;                                                // one thread; last, so that it ends first
};

}  // namespace boresight
