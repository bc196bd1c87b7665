// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/station_thread.h"

namespace boresight::app {

StationThread::StationThread(std::unique_ptr<Station> station, QObject* parent)
    : QObject(parent), m_station(std::move(station))
{
    qRegisterMetaType<NumberedRequest>();
    qRegisterMetaType<StationUpdate>();
    m_thread.setObjectName(QStringLiteral("station"));
    m_station->moveToThread(&m_thread);
    Station* const station_ = m_station.get();
    connect(&m_thread, &QThread::started, station_, &Station::start);
    connect(this, &StationThread::requested, station_, &Station::request);
    connect(this, &StationThread::updateTaken, station_, &Station::updateTaken);
    connect(this, &StationThread::shutDownRequested, station_, &Station::shutDown);
    connect(station_, &Station::started, this, &StationThread::started);
    connect(station_, &Station::updated, this, &StationThread::updated);
    connect(station_, &Station::finished, this, &StationThread::finished);
    // Its timers and sockets must end on the thread they live on.
    connect(
        &m_thread, &QThread::finished, station_, [this] { m_station.reset(); }, Qt::DirectConnection);
}

StationThread::~StationThread()
{
    m_thread.quit();
    m_thread.wait();
}

void StationThread::start()
{
    m_thread.start(QThread::TimeCriticalPriority);
}

}  // namespace boresight::app
