// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/can/can_link.h"
#include "core/can/fdcanusb_protocol.h"
#include "core/serial/line_splitter.h"
#include "core/serial/serial_port_check.h"
#include "core/serial/stable_port.h"

#include <QSerialPort>
#include <QTimer>

#include <deque>
#include <optional>

// A CAN-FD bus behind an fdcanusb or mjcanfd-usb-1x adapter (or a moteus UART, or the pseudo-terminal of the simulated
// adapter): lines of text over a serial port. Lives on the thread of its owner's event loop.
//
// "OK" only means that the adapter queued a frame. An adapter says OK even while its controller is bus-off. So after
// 200 ms without a received frame the link asks for the bus status, and restarts a controller that is off (adapters
// with factory settings do not restart it). It does so at most once a second, like "restart-ms 1000" of SocketCAN.
//
// A wrong port name may lead to a radio, which would read our lines as its own commands. So each opening begins with
// one query for the bus status, and no frame is sent before the port has answered like an adapter. A port that does not
// answer within kProbeTime is closed. It stays closed until close() is called or another device is in its place.
namespace boresight {

enum class LineChecksum
{
    Off,  // USB adapters: the cable checks its data already
    On,   // moteus UART: added to our lines, and required in every answer
};

class FdcanusbLink final : public CanLink
{
    Q_OBJECT

public:
    static constexpr std::chrono::milliseconds kOkDeadline{50};
    // Ten missed exchanges with both axes. With this, bus-off is on the screen within 300 ms.
    static constexpr std::chrono::milliseconds kCheckPeriod{200};
    static constexpr std::chrono::seconds kRestartPeriod{1};
    // An adapter answers within 50 ms. This time is shorter than a scan of the bus, which then reports why no drive
    // answers.
    static constexpr std::chrono::milliseconds kProbeTime{500};

    // `clock` outlives the link.
    FdcanusbLink(StablePort path, const Clock& clock, LineChecksum checksum = LineChecksum::Off,
                 QObject* parent = nullptr);
    FdcanusbLink(const QString& path, const Clock& clock, LineChecksum checksum = LineChecksum::Off,
                 QObject* parent = nullptr);
    ~FdcanusbLink() override;

    [[nodiscard]] QString name() const override;
    [[nodiscard]] LinkStatus status() const override { return m_status; }
    Result<> open() override;
    void close() override;
    Result<> send(std::span<const CanFrame> frames) override;

private:
    enum class Command
    {
        Frame,
        Status,
        Restart,
    };
    struct Pending  // a command without an answer yet; answers come in the order of the commands
    {
        Command command{};
        SteadyTime deadline{};
    };
    struct Probe  // whether an adapter is behind the port
    {
        SteadyTime begun{};
        bool proven = false;                    // the port has answered like an adapter
        std::optional<PortIdentity> foreign{};  // a port that has not answered like one, and is left alone
    };

    Result<> openPort(const QString& device);
    void appendLine(QByteArray& lines, std::string_view line, Command command);
    Result<> writeLines(const QByteArray& lines);
    void readPort();
    void handleLine(std::string_view line);
    void handle(const CanFrame& frame);
    void handle(const fdcanusb::Accepted&);
    void handle(const fdcanusb::Refusal& refusal);
    void handle(const fdcanusb::BusStatus& bus);
    void handle(const fdcanusb::RemoteFrame&) {}
    void handle(const fdcanusb::Unreadable&) { ++m_unreadableLines; }
    Command takePending();

    void checkDeadlines();
    [[nodiscard]] bool isProbing() const { return !m_probe.proven && m_status.state == LinkState::Up; }
    void checkProbe();
    void checkBus(QByteArray& lines);
    void restartController();
    void updateStatus(LinkState state);
    void reportBus(LinkState state, const QString& trouble);
    void handlePortError(QSerialPort::SerialPortError error);
    void lose();

    StablePort m_path;
    const Clock& m_clock;
    LineChecksum m_checksum;
    QSerialPort m_port{this};
    QTimer m_deadlineTimer{this};
    LineSplitter m_splitter;
    std::deque<Pending> m_pending;
    LinkStatus m_status;
    bool m_busOff = false;     // by the last bus status, until a frame is received
    QString m_busTrouble;      // until a frame is received or the bus status is good
    QString m_adapterTrouble;  // until a frame is accepted again
    std::uint64_t m_unreadableLines = 0;
    Probe m_probe;
    SteadyTime m_lastCheck{};    // when the bus status was last asked for, or was not needed
    SteadyTime m_lastRestart{};  // when the controller was last restarted
};

}  // namespace boresight
