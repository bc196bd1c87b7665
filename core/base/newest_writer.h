// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <QObject>
#include <QString>
#include <QThreadPool>

#include <functional>
#include <memory>

// Writes files in a worker, so that its own thread never waits. While the worker is busy, only the newest of the
// waiting jobs is kept.
namespace boresight {

class NewestWriter final : public QObject
{
    Q_OBJECT

public:
    using Job = std::function<Result<>()>;  // must use only its own copies

    explicit NewestWriter(QObject* parent = nullptr);
    ~NewestWriter() override;  // flushes

    void write(Job job);
    // Waits until the newest job is done and returns its result. Needs no event loop.
    Result<> flush();

Q_SIGNALS:
    // The result of each job that was begun. Emitted from the event loop.
    void written();
    void failed(const QString& reason);
    void jobDone();  // from the worker, to this object

private:
    void start(Job job);
    void finish();

    // The result of the last job. The worker uses it until the job ends.
    std::shared_ptr<Result<>> m_outcome = std::make_shared<Result<>>();
    Job m_next;              // the waiting job; null: none
    bool m_writing = false;  // finish() is still to be called
    QThreadPool m_worker;    // one thread; last, so that it ends first
};

}  // namespace boresight
