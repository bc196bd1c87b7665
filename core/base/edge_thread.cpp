// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/edge_thread.h"

#include <utility>

namespace boresight {

EdgeThread::EdgeThread(const QString& name, std::unique_ptr<QObject> inside) : m_inside(std::move(inside))
{
    m_thread.setObjectName(name);
    m_inside->moveToThread(&m_thread);
    connect(
        this, &EdgeThread::posted, m_inside.get(), [](const std::function<void()>& job) { job(); },
        Qt::QueuedConnection);
    // The timers and sockets of the object must end on its own thread.
    connect(
        &m_thread, &QThread::finished, m_inside.get(), [this] { m_inside.reset(); }, Qt::DirectConnection);
    m_thread.start(QThread::NormalPriority);
}

// The last job ends the event loop. Calling QThread::quit() from here would overtake the waiting jobs.
EdgeThread::~EdgeThread()
{
    post([this] { m_thread.quit(); });
    m_thread.wait();
}

}  // namespace boresight

#include "moc_edge_thread.cpp"
