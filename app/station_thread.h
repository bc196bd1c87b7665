// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/station/station.h"

#include <QObject>
#include <QThread>

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

// Runs a Station on its own thread, and after a reconnect the next Station on the next thread. Created, used and
// destroyed on the main thread. Only queued signals with values pass between the two threads. A reconnect blocks
// nobody: the old thread ends by itself after its station has written everything. Then nextWanted() asks for the
// profile of the next station, and begin() brings it, after any time. The next station is built on its own thread,
// because it reads files. Between two stations no mount is connected. A STOP of that time is sent to the next station,
// so that nothing moves there. All other requests of that time are refused.
namespace boresight::app {

class StationThread : public QObject
{
    Q_OBJECT

public:
    // Builds a station for this profile without starting it. It always returns a station: an unusable bus is an alarm
    // of the station, which can then be asked for another mount. Called on the thread of the station.
    using Build = std::function<std::unique_ptr<Station>(const profile::Profile&)>;

    // Takes the first station, which must not be started yet. `build` makes the later ones.
    StationThread(std::unique_ptr<Station> station, Build build, QObject* parent = nullptr);
    // Ends the thread and destroys the station. Call shutDown() and wait for finished() first. Otherwise only the
    // watchdog of the drives stops them.
    ~StationThread() override;

    void start();

public Q_SLOTS:
    // Builds and starts the next station. Does nothing once the program is ending.
    void begin(const boresight::profile::Profile& profile);

Q_SIGNALS:
    // Signals to the station.
    void requested(const boresight::NumberedRequest& request);
    void updateTaken();
    void shutDownRequested();
    // Signals from the station.
    void started(const QString& listening, const QString& problem);
    void updated(const boresight::StationUpdate& update);
    void finished();
    void profileApplied(const boresight::profile::Profile& profile);
    // Between two stations: a reconnect with this profile was requested.
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
    bool m_isBetween = false;              // no station receives requests now
    std::vector<std::uint64_t> m_stops;    // requests for STOP from that time
    std::vector<std::uint64_t> m_refused;  // all other requests from that time
    bool m_shuttingDown = false;           // no further station is started
};

}  // namespace boresight::app
