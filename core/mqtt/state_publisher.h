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

// Publishes the position and state of the mount in the format of the sensor: one line of JSON on PREFIXstate, each
// second and whenever the state changes. PREFIXavailability is "online" or, retained as the will, "offline". Station
// thread.
namespace boresight::mqtt {

class Connection;

// An active alarm. `text` is for people, the rest for programs.
struct PublishedAlarm
{
    QString id;     // "drive.silent"
    QString about;  // "azimuth"; empty: the station
    QString severity;
    QString text;
};

struct PublishedBrake
{
    QString state;    // "set", "opens", "open", "closes", "failed"
    QString problem;  // of its output, for people; empty without

    bool operator==(const PublishedBrake&) const = default;
};

struct PublishedSwitch
{
    QString end;      // "azimuth lower"
    QString state;    // "free", "pressed", "unread"
    QString problem;  // why it cannot be read, for people

    bool operator==(const PublishedSwitch&) const = default;
};

// Unknown values are empty. Programs read the words, so they are not translated.
struct PublishedState
{
    UtcTime utc;
    QString state;  // "TRACK"
    QString fault;  // what stopped the mount, for people; empty if nothing did
    bool stopLatched = false;
    bool limited = false;
    bool simulated = false;
    std::optional<SkyPointing> actual;
    std::optional<SkyPointing> commanded;
    std::optional<SkyPointing> target;
    std::optional<Angle> azimuthAxis;  // mechanical: 370° is not 10°
    std::optional<Angle> elevationAxis;
    QString targetText;                        // "P 339.50 57.00"
    QString commander;                         // "rotctld 127.0.0.1:51234"
    bool isLinked = false;                     // every axis has answered lately
    QString linkProblem;                       // of the line to the mount, for people; empty without
    std::optional<PublishedBrake> brake;       // empty: the mount has none
    std::vector<PublishedSwitch> endSwitches;  // of the profile
    std::vector<PublishedAlarm> alarms;        // worst first
};

[[nodiscard]] QByteArray toJson(const PublishedState& state);

class StatePublisher : public QObject
{
    Q_OBJECT

public:
    static constexpr std::chrono::seconds kPeriod{1};

    // The connection outlives the publisher. `prefix` may end with a slash or not.
    StatePublisher(Connection& client, const Clock& clock, const QString& prefix, QObject* parent = nullptr);

    // The will that the broker must get before the connection is opened.
    [[nodiscard]] static Message will(const QString& prefix);

    // Call it whenever the state may have changed. Publishes at once after a change, otherwise once each kPeriod.
    void show(const PublishedState& state);
    // Publishes an event of the schedule as one line of JSON on PREFIXschedule.
    void tell(const QByteArray& moment);
    void sayOffline();

private:
    void sayOnline();
    [[nodiscard]] bool isNews(const PublishedState& state) const;

    Connection& m_client;
    const Clock& m_clock;
    QString m_prefix;
    std::optional<SteadyTime> m_lastTime;  // when m_last was published
    PublishedState m_last;
};

}  // namespace boresight::mqtt
