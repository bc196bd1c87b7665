// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cross_check/sensor_watch.h"
#include "core/inputs/sensor_factory.h"
#include "core/inputs/station_broker.h"

#include <QObject>
#include <QThreadPool>

#include <memory>
#include <optional>
#include <string>

// The orientation sensor that the profile names. It is opened and closed when the profile changes. SensorWatch judges
// its values. A thread of its own reads the magnetic model. Station thread.
namespace boresight {

class StationSensor : public QObject
{
    Q_OBJECT

public:
    // Profile, clock, log, alarms and broker outlive this.
    StationSensor(const profile::InForce& profile, const Clock& clock, EventLog& log, AlarmBoard& alarms,
                  StationBroker& broker, QObject* parent);

    // Call before open().
    void setMaker(SensorMaker maker) { m_maker = std::move(maker); }
    void open();
    void close();
    // A sensor that did not change stays open.
    void profileChanged(const profile::Profile& before, const profile::Profile& after);

    [[nodiscard]] SensorStatus status() const;
    [[nodiscard]] SensorEvidence evidence() const { return m_watch.evidence(); }
    [[nodiscard]] SensorWatch& watch() { return m_watch; }

Q_SIGNALS:
    void modelRead();  // emitted on the reader thread, received by this object

private:
    struct ModelAnswer
    {
        Result<Angle> declination;
        QString model;  // name and years of the model
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
    ModelAnswer m_model;       // the reader thread writes it until modelRead()
    bool m_isReading = false;  // until takeModel()
    bool m_readAgain = false;  // wanted again while reading
    QThreadPool m_reader;      // one thread; last member, so that it ends first
};

}  // namespace boresight
