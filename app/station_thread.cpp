// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/station_thread.h"

#include "core/base/text.h"

#include <utility>

namespace boresight::app {

StationThread::StationThread(std::unique_ptr<Station> station, Build build, QObject* parent)
    : QObject(parent), m_build(std::move(build))
{
    qRegisterMetaType<NumberedRequest>();
    qRegisterMetaType<StationUpdate>();
    qRegisterMetaType<profile::Profile>();
    connect(this, &StationThread::shutDownRequested, this, &StationThread::shutDown);
    connect(this, &StationThread::requested, this, &StationThread::keep);
    prepare();
    station->moveToThread(&m_running->thread);
    listenTo(*station);
    m_running->station = std::move(station);
    launch();
}

void StationThread::prepare()
{
    m_running = std::make_unique<Running>();
    QThread& thread = m_running->thread;
    thread.setObjectName(QStringLiteral("station"));
    // The timers and sockets of the station must end on their own thread.
    connect(
        &thread, &QThread::finished, &thread, [running = m_running.get()] { running->station.reset(); },
        Qt::DirectConnection);
}

void StationThread::listenTo(const Station& station)
{
    connect(&station, &Station::started, this, &StationThread::started);
    connect(&station, &Station::updated, this, &StationThread::show);
    connect(&station, &Station::finished, this, &StationThread::finished);
    connect(&station, &Station::profileApplied, this, &StationThread::profileApplied);
    connect(&station, &Station::reconnectWanted, this, &StationThread::reconnect);
}

// From this call on the station receives requests. The station starts as soon as its thread runs.
void StationThread::launch()
{
    if (m_shuttingDown) {
        return;
    }
    m_isBetween = false;
    Station* const station = m_running->station.get();
    connect(this, &StationThread::requested, station, &Station::request);
    connect(this, &StationThread::updateTaken, station, &Station::updateTaken);
    connect(this, &StationThread::shutDownRequested, station, &Station::shutDown);
    QMetaObject::invokeMethod(station, &Station::start, Qt::QueuedConnection);
    for (const std::uint64_t id : std::exchange(m_stops, {})) {
        QMetaObject::invokeMethod(
            station, [station, id] { station->request({.id = id, .request = request::Stop{}}); }, Qt::QueuedConnection);
    }
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

// Between two stations there is no station to wait for.
void StationThread::shutDown()
{
    m_shuttingDown = true;
    if (m_isBetween) {
        Q_EMIT finished();
    }
}

// The old station has stopped its drives and closed its bus before it requested this.
void StationThread::reconnect(const profile::Profile& profile)
{
    m_isBetween = true;
    if (m_shuttingDown) {
        Q_EMIT finished();
        return;
    }
    connect(&m_running->thread, &QThread::finished, this, [this, profile] { askForNext(profile); });
    m_running->thread.quit();
}

void StationThread::askForNext(const profile::Profile& wanted)
{
    end();
    if (!m_shuttingDown) {
        Q_EMIT nextWanted(wanted);
    }
}

void StationThread::begin(const profile::Profile& profile)
{
    if (m_running || m_shuttingDown) {
        return;
    }
    prepare();
    const auto build = [this, running = m_running.get(), profile] {
        running->station = m_build(profile);
        listenTo(*running->station);
        QMetaObject::invokeMethod(this, &StationThread::launch, Qt::QueuedConnection);
    };
    connect(&m_running->thread, &QThread::started, &m_running->thread, build, Qt::DirectConnection);
    start();
}

// A request for the previous mount must not move the next one.
void StationThread::keep(const NumberedRequest& request)
{
    if (m_isBetween) {
        (std::holds_alternative<request::Stop>(request.request) ? m_stops : m_refused).push_back(request.id);
    }
}

void StationThread::show(const StationUpdate& update)
{
    if (m_refused.empty()) {
        Q_EMIT updated(update);
        return;
    }
    StationUpdate withRefusals = update;
    const Error refusal{ErrorCode::NotAvailable, Text::tr("No mount was connected at that moment. Try again.")};
    for (const std::uint64_t id : std::exchange(m_refused, {})) {
        withRefusals.answers.push_back({.requestId = id, .error = refusal});
    }
    Q_EMIT updated(withRefusals);
}

void StationThread::start()
{
    m_running->thread.start(QThread::TimeCriticalPriority);
}

}  // namespace boresight::app

#include "moc_station_thread.cpp"
