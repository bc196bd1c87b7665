// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/can_frame.h"
#include "core/base/result.h"

#include <QObject>
#include <QString>

#include <cstdint>
#include <span>

// One CAN-FD bus, whatever carries it: SocketCAN, an fdcanusb adapter, the built-in simulated pair. Lives on the
// station thread; nothing blocks. A link reports what it knows of itself (interface down, adapter gone); whether a
// drive still answers is judged by the age of its replies, above. A link never re-opens by itself: its owner calls
// open().
namespace boresight {

enum class LinkState
{
    Closed,  // not opened yet, or closed by us
    Up,      // frames can be sent
    Down,    // the interface is there but down, bus-off or refuses frames; may come back by itself
    Lost,    // the interface or adapter is gone: open() again
};

struct LinkStatus
{
    LinkState state = LinkState::Closed;
    QString text;                 // for the operator: what, where, what to do; empty while all is well
    std::uint64_t sent = 0;       // frames handed to the interface
    std::uint64_t received = 0;   // frames received
    std::uint64_t dropped = 0;    // frames the kernel or adapter lost, unreadable lines
    std::uint64_t busErrors = 0;  // error frames, ERR answers, missing OKs
    bool leftAlone = false;       // Lost, and open() tries nothing before close() was called or the device changed

    bool operator==(const LinkStatus&) const = default;
};

class CanLink : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    // The name the user gave: "socketcan:can0", "fdcanusb:/dev/…", "simulated".
    [[nodiscard]] virtual QString name() const = 0;
    [[nodiscard]] virtual LinkStatus status() const = 0;

    // Opens or re-opens. An error text names the interface or port and the remedy. An interface that is there but down
    // opens too: state Down, the status text names the remedy, and it comes up by itself.
    virtual Result<> open() = 0;
    virtual void close() = 0;

    // Hands all frames over in one go (one write where the adapter allows it). Success means queued, not delivered.
    virtual Result<> send(std::span<const CanFrame> frames) = 0;

Q_SIGNALS:
    void frameReceived(const boresight::CanFrame& frame);
    // State or text changed. Counters alone do not cause it: a bad bus makes thousands of errors a second.
    void statusChanged(const boresight::LinkStatus& status);
};

}  // namespace boresight

Q_DECLARE_METATYPE(boresight::CanFrame)
Q_DECLARE_METATYPE(boresight::LinkStatus)
