// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cross_check/sensor_watch.h"
#include "core/station/sensor_factory.h"
#include "core/station/station_broker.h"

#include <QObject>
#include <QThreadPool>

#include <memory>
#include <optional>
#include <string>

// The orientation sensor as the station uses it: the source that the profile names, opened and closed as the profile
// changes, and what SensorWatch makes of its values. The magnetic model is read in a
// thread of its own. Station thread.
namespace boresight {

class StationSensor : public QObject
{
    Q_OBJECT

public:
    // Profile, clock, log, alarms and broker outlive this.
    StationSensor(const profile::InForce& profile, const Clock& clock, EventLog& log, AlarmBoard& alarms,
                  StationBroker& broker, QObject* parent);

    // Before open().
    void setMaker(SensorMaker maker) { m_maker = std::move(maker); }
    void open();
    void close();
    // A source that did not change goes on.
    void profileChanged(const profile::Profile& before, const profile::Profile& after);

    [[nodiscard]] SensorStatus status() const;
    [[nodiscard]] SensorEvidence evidence() const { return m_watch.evidence(); }
    [[nodiscard]] SensorWatch& watch() { return m_watch; }

Q_SIGNALS:
    void modelRead();  // from the reader, to this object

private:
    struct ModelAnswer
    {
        Result<Angle> declination;
        QString model;  // its name and its years
        QString expiry;
    };
    static ModelAnswer askModel(const QString& path, const Site& site, double year);
    [[nodiscard]] bool hasModel() const;
    void readModel();
    void takeModel();

    const profile::InForce& m_profile;
    const Clock& m_clock;
    EventLog& m_log;
    StationBroker& m_broker;
    SensorWatch m_watch;
    SensorMaker m_maker;
    std::unique_ptr<orientation::SensorSource> m_source;
    bool m_open = false;
    ModelAnswer m_model;       // the reader's until it has read
    bool m_isReading = false;  // takeModel() is still to come
    bool m_readAgain = false;  // asked for meanwhile
    QThreadPool m_reader;      // one thread; last, so that it ends first
};

}  // namespace boresight
