// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/station/station.h"

#include <QObject>
#include <QThread>

#include <functional>
#include <memory>

// Runs a Station on a thread of its own, and after a reconnect the next one on the next thread. Made, used and
// destroyed on the main thread; everything between the two threads is a queued signal carrying values. A reconnect
// blocks nobody: the old thread ends by itself, what its station still writes included, before the next one is built.
namespace boresight::app {

class StationThread : public QObject
{
    Q_OBJECT

public:
    // Builds a station that is not started yet, for the profile in question. There always is one: a bus that cannot be
    // used is its alarm, and it can be asked for another mount.
    using Build = std::function<std::unique_ptr<Station>(const profile::Profile&)>;

    // Takes the first station, which must not be started yet; `build` makes the others.
    StationThread(std::unique_ptr<Station> station, Build build, QObject* parent = nullptr);
    // Ends the thread and destroys the station. Call shutDown() and await finished() first, else the drives are left to
    // their watchdog.
    ~StationThread() override;

    void start();

Q_SIGNALS:
    // To the station.
    void requested(const boresight::NumberedRequest& request);
    void updateTaken();
    void shutDownRequested();
    // From the station.
    void started(const QString& listening, const QString& problem);
    void updated(const boresight::StationUpdate& update);
    void finished();
    void profileApplied(const boresight::profile::Profile& profile);

private:
    struct Running
    {
        QThread thread;
        std::unique_ptr<Station> station;
    };

    void take(std::unique_ptr<Station> station);
    void end();
    void reconnect(const profile::Profile& profile);
    void beginNext(const profile::Profile& profile);
    void shutDown();

    Build m_build;
    std::unique_ptr<Running> m_running;
    bool m_shuttingDown = false;  // then no next station is begun
};

}  // namespace boresight::app
