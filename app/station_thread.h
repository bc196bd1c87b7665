// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/station/station.h"

#include <QObject>
#include <QThread>

// Runs a Station on a thread of its own. Made, used and destroyed on the main thread; everything between the two
// threads is a queued signal carrying values.
namespace boresight::app {

class StationThread : public QObject
{
    Q_OBJECT

public:
    // Takes the station, which must not be started yet.
    explicit StationThread(std::unique_ptr<Station> station, QObject* parent = nullptr);
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

private:
    QThread m_thread;
    std::unique_ptr<Station> m_station;
};

}  // namespace boresight::app
