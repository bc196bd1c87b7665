// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/mqtt/broker.h"
#include "core/units/sky.h"

#include <QByteArray>
#include <QObject>
#include <QString>

#include <optional>
#include <vector>

// Tells the broker where the mount is and what it does, in the sensor's style: one line of JSON on PREFIXstate, each
// second and whenever it changes state. PREFIXavailability says "online" or, retained as the will, "offline". Station
// thread.
namespace boresight::mqtt {

class Connection;

// One that is active. `text` is for people, the rest for programs.
struct PublishedAlarm
{
    QString id;     // "drive.silent"
    QString about;  // "azimuth"; empty: the station
    QString severity;
    QString text;
};

// Unknown is empty. Programs read the words, so they are in no language but the protocol's.
struct PublishedState
{
    UtcTime utc;
    QString state;  // "TRACK"
    QString fault;  // what stopped the mount, for people; empty without
    bool stopLatched = false;
    bool limited = false;
    bool simulated = false;
    std::optional<SkyPointing> actual;
    std::optional<SkyPointing> commanded;
    std::optional<SkyPointing> target;
    std::optional<Angle> azimuthAxis;  // mechanical: 370° is not 10°
    std::optional<Angle> elevationAxis;
    QString targetText;                  // "P 339.50 57.00"
    QString commander;                   // "rotctld 127.0.0.1:51234"
    bool isLinked = false;               // every axis has answered lately
    QString linkProblem;                 // of the line to the mount, for people; empty without
    std::vector<PublishedAlarm> alarms;  // worst first
};

[[nodiscard]] QByteArray toJson(const PublishedState& state);

class StatePublisher : public QObject
{
    Q_OBJECT

public:
    static constexpr std::chrono::seconds kPeriod{1};

    // The connection outlives the publisher. `prefix` with or without its last slash.
    StatePublisher(Connection& client, const Clock& clock, const QString& prefix, QObject* parent = nullptr);

    // What the broker has to know before it is connected to.
    [[nodiscard]] static Message will(const QString& prefix);

    // To be called as often as the state may have changed; publishes when it is time.
    void show(const PublishedState& state);
    // A moment of the schedule, as one line of JSON on PREFIXschedule.
    void tell(const QByteArray& moment);
    void sayOffline();

private:
    void sayOnline();
    [[nodiscard]] bool isNews(const PublishedState& state) const;

    Connection& m_client;
    const Clock& m_clock;
    QString m_prefix;
    std::optional<SteadyTime> m_lastTime;  // published
    PublishedState m_last;
};

}  // namespace boresight::mqtt
