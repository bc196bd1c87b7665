// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_board.h"
#include "core/alarms/event_log.h"
#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/messages/request.h"
#include "core/messages/station_status.h"
#include "core/mount/mount_driver.h"
#include "core/mount/sensor_course.h"
#include "core/profile/in_force.h"

#include <QObject>
#include <QString>

#include <functional>
#include <memory>
#include <optional>

// A mount with the line that leads to it: opened, closed and served by the station, which knows no kind of rotator
// more than this. Made on the main thread, then moved to the station thread with its parent; nothing blocks.
namespace boresight {

class MountConnection : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    [[nodiscard]] virtual MountDriver& driver() = 0;
    [[nodiscard]] virtual const MountDriver& driver() const = 0;

    // Nothing real moves: what is set and found belongs to the simulation.
    [[nodiscard]] virtual bool simulated() const = 0;
    // Whether this program may command the mount at all: another one may have it.
    [[nodiscard]] virtual const Result<>& mine() const = 0;
    // Opens the line if it is not open. What is wrong with it is an alarm, and open() is called again each second.
    virtual void open() = 0;
    virtual void close() = 0;
    // After the control has commanded: sends, and keeps what is to be kept. Once per tick.
    virtual void send() = 0;

    // What stands in the way of a request of the operator; then what the control has admitted is carried out here, if
    // it is about the mount itself.
    [[nodiscard]] virtual Result<> admits(const Request& request) const = 0;
    [[nodiscard]] virtual Result<> carryOut(const Request& request) = 0;

    // Whatever of it must react: the driver reads the profile in force as it goes.
    virtual void profileChanged(const profile::Profile& before, const profile::Profile& after) = 0;
    // How a sensor on the antenna has seen the azimuth turn.
    virtual void setCourse(const std::optional<SensorCourse>& course) = 0;
    // Its part of the status: the line, and what it found out about the mount.
    virtual void describe(StationStatus& status) const = 0;
};

// Called once. All of them outlive what is made.
using MountMaker = std::function<std::unique_ptr<MountConnection>(const profile::InForce& profile, const Clock& clock,
                                                                  EventLog& log, AlarmBoard& alarms)>;

}  // namespace boresight
