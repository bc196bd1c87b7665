// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/can_frame.h"
#include "core/base/result.h"

#include <QObject>
#include <QString>

#include <cstdint>
#include <span>

// One CAN-FD bus of any kind: SocketCAN, an fdcanusb adapter, or the built-in simulated pair. Lives on the station
// thread. Never blocks. A link reports what it knows itself (interface down, adapter gone). Its owner judges by the age
// of the replies whether a drive still answers. A link never opens again by itself: its owner calls open().
namespace boresight {

enum class LinkState
{
    Closed,  // not opened yet, or closed by us
    Up,      // frames can be sent
    Down,    // the interface exists but is down, bus-off or refuses frames; may recover by itself
    Lost,    // the interface or adapter is gone; recovers only by open()
};

struct LinkStatus
{
    LinkState state = LinkState::Closed;
    QString text;                 // for the operator: what, where, what to do; empty if all is well
    std::uint64_t sent = 0;       // frames handed to the interface
    std::uint64_t received = 0;   // frames received
    std::uint64_t dropped = 0;    // frames that the kernel or adapter lost, unreadable lines
    std::uint64_t busErrors = 0;  // error frames, ERR answers, missing OKs
    bool leftAlone = false;       // Lost, and open() does nothing before close() or a change of the device

    bool operator==(const LinkStatus&) const = default;
};

class CanLink : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    // The name that the user entered: "socketcan:can0", "fdcanusb:/dev/…", "simulated".
    [[nodiscard]] virtual QString name() const = 0;
    [[nodiscard]] virtual LinkStatus status() const = 0;

    // Opens the link, or opens it again. An error text contains the interface or port and the remedy. An interface that
    // exists but is down opens with the state Down. Its status text contains the remedy, and it recovers by itself.
    virtual Result<> open() = 0;
    virtual void close() = 0;

    // Hands all frames over at once (in one write if the adapter allows that). Success means that the frames are
    // queued, not that they were delivered.
    virtual Result<> send(std::span<const CanFrame> frames) = 0;

Q_SIGNALS:
    void frameReceived(const boresight::CanFrame& frame);
    // The state or the text changed. A change of the counters alone is not reported: a bad bus makes thousands of
    // errors a second.
    void statusChanged(const boresight::LinkStatus& status);
};

}  // namespace boresight

Q_DECLARE_METATYPE(boresight::CanFrame)
Q_DECLARE_METATYPE(boresight::LinkStatus)
