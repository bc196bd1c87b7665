// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/station/station.h"

#include <QObject>
#include <QThread>

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

// Runs a Station on a thread of its own, and after a reconnect the next one on the next thread. Made, used and
// destroyed on the main thread; everything between the two threads is a queued signal carrying values. A reconnect
// blocks nobody: the old thread ends by itself, what its station still writes included. Then nextWanted() asks for the
// profile of the next station. begin() brings it, after any time. The next station is built on its own thread, because
// it reads files. In between no mount is connected: a STOP of that time is sent to the next station, so that nothing
// moves there. All other requests of that time are refused.
namespace boresight::app {

class StationThread : public QObject
{
    Q_OBJECT

public:
    // Builds a station that is not started yet, for the profile in question. There always is one: a bus that cannot be
    // used is its alarm, and it can be asked for another mount. Called on the thread of the station.
    using Build = std::function<std::unique_ptr<Station>(const profile::Profile&)>;

    // Takes the first station, which must not be started yet; `build` makes the others.
    StationThread(std::unique_ptr<Station> station, Build build, QObject* parent = nullptr);
    // Ends the thread and destroys the station. Call shutDown() and await finished() first, else the drives are left to
    // their watchdog.
    ~StationThread() override;

    void start();

public Q_SLOTS:
    // Builds and starts the next station. Once the program is to end there is none.
    void begin(const boresight::profile::Profile& profile);

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
    // Between two stations: a reconnect with this profile was asked for.
    void nextWanted(const boresight::profile::Profile& wanted);

private:
    struct Running
    {
        QThread thread;
        std::unique_ptr<Station> station;
    };

    void prepare();
    void listenTo(const Station& station);
    void launch();
    void end();
    void reconnect(const profile::Profile& profile);
    void askForNext(const profile::Profile& wanted);
    void shutDown();
    void keep(const NumberedRequest& request);
    void show(const StationUpdate& update);

    Build m_build;
    std::unique_ptr<Running> m_running;
    bool m_isBetween = false;              // two stations: nobody receives a request
    std::vector<std::uint64_t> m_stops;    // that were asked for in that time
    std::vector<std::uint64_t> m_refused;  // the other requests of that time
    bool m_shuttingDown = false;           // then no next station is begun
};

}  // namespace boresight::app
