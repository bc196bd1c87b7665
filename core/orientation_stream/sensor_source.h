// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/orientation/json_payload.h"
#include "core/orientation/orientation.h"
#include "core/orientation/refusal.h"

#include <QObject>
#include <QString>

#include <optional>

// Where orientations come from: a serial port, an MQTT broker, the simulated sensor. Lives on the station thread;
// nothing blocks. It is opened once and from then on comes back by itself, with growing pauses, until it is closed: the
// owner only listens. Whether what comes is young enough, or makes sense, is judged above (Judge).
namespace boresight::orientation {

struct SourceStatus
{
    bool open = false;  // the port is open, the broker has let us in
    QString problem;    // one line for the operator: what, where, what to do; empty while all is well
    Counts counts;
    std::optional<ReportedState> firmware = {};  // what it says of itself; over a serial port nothing

    bool operator==(const SourceStatus&) const = default;
};

class SensorSource : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    // As the screen and the log call it: "serial /dev/ttyUSB0", "mqtt broker.example:1883".
    [[nodiscard]] virtual QString name() const = 0;
    [[nodiscard]] virtual const SourceStatus& status() const = 0;

    virtual void open() = 0;
    virtual void close() = 0;

Q_SIGNALS:
    void received(const boresight::orientation::Orientation& orientation);
    // `open` or `problem` changed: once for each new trouble, however often it is tried again.
    void statusChanged(const boresight::orientation::SourceStatus& status);
};

}  // namespace boresight::orientation
