// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/orientation/json_payload.h"
#include "core/orientation/orientation.h"
#include "core/orientation/refusal.h"

#include <QObject>
#include <QString>

#include <optional>

// A source of orientations: a serial port, an MQTT broker or the simulated sensor. Lives on the station thread; nothing
// blocks. Open it once. Until it is closed it reconnects by itself, with growing pauses, and the owner only listens.
// The Judge decides whether values are young enough and plausible.
namespace boresight::orientation {

struct SourceStatus
{
    bool open = false;  // the port is open, or the broker has accepted the connection
    QString problem;    // one line for the operator: what, where, what to do; empty: no problem
    Counts counts;
    std::optional<ReportedState> firmware = {};  // what the sensor reports about itself; never over a serial port

    bool operator==(const SourceStatus&) const = default;
};

class SensorSource : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    // The name on the screen and in the log: "serial /dev/ttyUSB0", "MQTT broker.example:1883".
    [[nodiscard]] virtual QString name() const = 0;
    [[nodiscard]] virtual const SourceStatus& status() const = 0;

    virtual void open() = 0;
    virtual void close() = 0;

Q_SIGNALS:
    void received(const boresight::orientation::Orientation& orientation);
    // `open` or `problem` changed. Emitted once for each new problem, however many attempts follow.
    void statusChanged(const boresight::orientation::SourceStatus& status);
};

}  // namespace boresight::orientation
