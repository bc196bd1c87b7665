// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QThread>

#include <functional>
#include <memory>

// A thread with an event loop for one object that data from outside can keep busy (a broker, a serial line). The
// object's work never delays the owner. Only values cross: the owner posts jobs, the object emits signals. Created,
// used and destroyed on the owner's thread.
namespace boresight {

class EdgeThread final : public QObject
{
    Q_OBJECT

public:
    // Starts the thread with normal priority, whatever the owner's priority is.
    EdgeThread(const QString& name, std::unique_ptr<QObject> inside);
    // Waits until the thread has done all posted jobs and destroyed the object.
    ~EdgeThread() override;

    // Runs the job on the thread, after the jobs posted before. Returns at once.
    void post(const std::function<void()>& job) { Q_EMIT posted(job); }

Q_SIGNALS:
    void posted(const std::function<void()>& job);

private:
    QThread m_thread;
    std::unique_ptr<QObject> m_inside;
};

}  // namespace boresight
