// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/base/file_descriptor.h"
#include "core/can/can_interface.h"
#include "core/can/can_link.h"
#include "core/can/socketcan_frame.h"

#include <QSocketNotifier>

#include <memory>

// A CAN-FD bus behind a Linux network interface, over a raw AF_CAN socket. Lives on the thread of its owner's event
// loop. Bit rates and sample points belong to the interface and are set with `ip link`. Wrong values are reported.
// Error frames are read, so missing acknowledgement, error-passive and bus-off are reported separately. Frames that the
// kernel dropped are counted.
namespace boresight {

class SocketCanLink final : public CanLink
{
    Q_OBJECT

public:
    // `clock` outlives the link.
    SocketCanLink(QString interface, const Clock& clock, QObject* parent = nullptr);
    SocketCanLink(QString interface, std::unique_ptr<socketcan::CanInterface> access, const Clock& clock,
                  QObject* parent = nullptr);
    ~SocketCanLink() override;

    [[nodiscard]] QString name() const override;
    [[nodiscard]] LinkStatus status() const override { return m_status; }
    Result<> open() override;
    void close() override;
    Result<> send(std::span<const CanFrame> frames) override;

private:
    // All troubles of an open socket. Each is shown until it is known to be over.
    struct Trouble
    {
        bool interfaceDown = false;
        bool busOff = false;
        bool transmitQueueFull = false;
        bool noAcknowledge = false;
        bool errorPassive = false;
        bool errorFrames = false;
        bool flooded = false;
    };

    void readSocket();
    [[nodiscard]] ssize_t readFrame(socketcan::RawFrame& raw);
    void handleFrame(const CanFrame& frame);
    void countLoad(SteadyTime now);
    void handleErrorFrame(const socketcan::RawFrame& raw);
    void handleSocketError(int error);
    void checkInterface();
    void follow(socketcan::ControllerState controller);
    void lose(const QString& reason);
    void closeSocket();
    void updateStatus();
    void setStatus(LinkState state, const QString& trouble);
    [[nodiscard]] QString troubleText() const;

    QString m_interface;
    socketcan::CanInterface* m_access;  // our child, so it moves to another thread with us
    const Clock& m_clock;
    FileDescriptor m_socket;
    std::unique_ptr<QSocketNotifier> m_notifier;
    LinkStatus m_status;
    Trouble m_trouble;
    SteadyTime m_lastErrorFrame{};
    SteadyTime m_loadSince{};  // start of the window in which frames are counted
    int m_loadFrames = 0;
    QString m_timingTrouble;
    bool m_isVirtual = false;
    std::uint32_t m_socketDrops = 0;  // as reported by the kernel since this socket was opened
};

}  // namespace boresight
