// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/station_thread.h"

namespace boresight::app {

StationThread::StationThread(std::unique_ptr<Station> station, Build build, QObject* parent)
    : QObject(parent), m_build(std::move(build))
{
    qRegisterMetaType<NumberedRequest>();
    qRegisterMetaType<StationUpdate>();
    qRegisterMetaType<profile::Profile>();
    take(std::move(station));
    connect(this, &StationThread::shutDownRequested, this, &StationThread::shutDown);
}

void StationThread::take(std::unique_ptr<Station> station)
{
    m_running = std::make_unique<Running>();
    m_running->station = std::move(station);
    QThread& thread = m_running->thread;
    Station* const station_ = m_running->station.get();
    thread.setObjectName(QStringLiteral("station"));
    station_->moveToThread(&thread);
    connect(&thread, &QThread::started, station_, &Station::start);
    connect(this, &StationThread::requested, station_, &Station::request);
    connect(this, &StationThread::updateTaken, station_, &Station::updateTaken);
    connect(this, &StationThread::shutDownRequested, station_, &Station::shutDown);
    connect(station_, &Station::started, this, &StationThread::started);
    connect(station_, &Station::updated, this, &StationThread::updated);
    connect(station_, &Station::finished, this, &StationThread::finished);
    connect(station_, &Station::profileApplied, this, &StationThread::profileApplied);
    connect(station_, &Station::reconnectWanted, this, &StationThread::reconnect);
    // Its timers and sockets must end on the thread they live on.
    connect(
        &thread, &QThread::finished, station_, [running = m_running.get()] { running->station.reset(); },
        Qt::DirectConnection);
}

StationThread::~StationThread()
{
    end();
}

void StationThread::end()
{
    if (m_running) {
        m_running->thread.quit();
        m_running->thread.wait();
        m_running.reset();
    }
}

// Between two stations there is nothing to wait for.
void StationThread::shutDown()
{
    m_shuttingDown = true;
    if (!m_running) {
        Q_EMIT finished();
    }
}

// The old station has left its drives and closed its bus before it asked for this.
void StationThread::reconnect(const profile::Profile& profile)
{
    connect(&m_running->thread, &QThread::finished, this, [this, profile] { beginNext(profile); });
    m_running->thread.quit();
}

void StationThread::beginNext(const profile::Profile& profile)
{
    end();
    if (m_shuttingDown) {
        Q_EMIT finished();
        return;
    }
    take(m_build(profile));
    start();
}

void StationThread::start()
{
    m_running->thread.start(QThread::TimeCriticalPriority);
}

}  // namespace boresight::app

#include "moc_station_thread.cpp"
