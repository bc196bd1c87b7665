// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_board.h"
#include "core/alarms/event_log.h"
#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/contacts/input_name.h"
#include "core/messages/request.h"
#include "core/messages/station_status.h"
#include "core/mount/mount_driver.h"
#include "core/mount/sensor_course.h"
#include "core/outputs/output.h"
#include "core/profile/in_force.h"

#include <QObject>
#include <QString>

#include <functional>
#include <memory>
#include <optional>

// A mount with the line to its hardware. The station opens, closes and serves it, and knows nothing else about a kind
// of rotator. Made on the main thread, then moved to the station thread with its parent. Never blocks.
namespace boresight {

class MountConnection : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    [[nodiscard]] virtual MountDriver& driver() = 0;
    [[nodiscard]] virtual const MountDriver& driver() const = 0;

    // Nothing real moves. Settings and findings belong to the simulation.
    [[nodiscard]] virtual bool simulated() const = 0;
    // Whether this program may command the mount. Another program may have it.
    [[nodiscard]] virtual const Result<>& mine() const = 0;
    // Opens the line if it is closed. A problem with the line is an alarm, and open() is called again each second.
    virtual void open() = 0;
    virtual void close() = 0;
    // After the control has commanded: sends the commands, and stores what must be stored. Once per tick.
    virtual void send() = 0;

    // admits(): the reason why a request of the operator is refused. carryOut(): carries out a request that the control
    // has admitted, if it is about the mount itself.
    [[nodiscard]] virtual Result<> admits(const Request& request) const = 0;
    [[nodiscard]] virtual Result<> carryOut(const Request& request) = 0;

    // For parts that must react to a change. The driver always reads the profile in force.
    virtual void profileChanged(const profile::Profile& before, const profile::Profile& after) = 0;
    // How far a sensor on the antenna saw the azimuth turn.
    virtual void setCourse(const std::optional<SensorCourse>& course) = 0;
    // What this pin of one of its boards reads. A mount without such pins says so.
    [[nodiscard]] virtual contacts::InputReading pin(const contacts::BoardPin& pin) const;
    // This pin of one of its boards as an output. Null: the mount has no such pins.
    [[nodiscard]] virtual std::unique_ptr<outputs::Output> pinOutput(const contacts::BoardPin& /*pin*/) { return {}; }
    // Fills in its part of the status: the line, and the facts about the mount.
    virtual void describe(StationStatus& status) const = 0;
};

// Called once. The references outlive the connection.
using MountMaker = std::function<std::unique_ptr<MountConnection>(const profile::InForce& profile, const Clock& clock,
                                                                  EventLog& log, AlarmBoard& alarms)>;

}  // namespace boresight
