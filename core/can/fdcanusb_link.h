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

// A CAN-FD bus behind an fdcanusb or mjcanfd-usb-1x adapter (or a moteus UART, or the simulated adapter's
// pseudo-terminal): text lines over a serial port. Lives on the thread of its owner's event loop.
//
// "OK" only says that the adapter queued a frame, and an adapter whose controller went bus-off still says OK. So after
// 200 ms without any received frame the link asks for the bus status, and restarts the controller when it is off
// (factory adapters do not do it themselves) - at most once a second, as "restart-ms 1000" does for SocketCAN.
//
// Behind a wrong name may be a radio, which would take our lines for its commands. So each opening begins with one
// question for the bus status, and no frame is sent before the port has answered as an adapter does. A port that has
// not within kProbeTime is closed, and stays closed until close() was called or another device has taken its place.
namespace boresight {

enum class LineChecksum
{
    Off,  // USB adapters: the cable already checks
    On,   // moteus UART: added to our lines and demanded on every answer
};

class FdcanusbLink final : public CanLink
{
    Q_OBJECT

public:
    static constexpr std::chrono::milliseconds kOkDeadline{50};
    // Ten exchanges with both axes missed: so that bus-off is on the screen within 300 ms.
    static constexpr std::chrono::milliseconds kCheckPeriod{200};
    static constexpr std::chrono::seconds kRestartPeriod{1};
    // An adapter answers within 50 ms. Shorter than a scan of the bus, which then reports why nobody answers.
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
    struct Pending  // a command whose OK, ERR or status line is still to come; answers keep the order of commands
    {
        Command command{};
        SteadyTime deadline{};
    };
    struct Probe  // is an adapter behind the port?
    {
        SteadyTime begun{};
        bool proven = false;                    // the port has answered as an adapter does
        std::optional<PortIdentity> foreign{};  // a port that has not, and is left alone
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
    bool m_busOff = false;     // by its last status, until a frame is received
    QString m_busTrouble;      // until a frame is received or the bus status is good
    QString m_adapterTrouble;  // until a frame is accepted again
    std::uint64_t m_unreadableLines = 0;
    Probe m_probe;
    SteadyTime m_lastCheck{};    // the bus status was asked for, or not needed
    SteadyTime m_lastRestart{};  // the controller was restarted
};

}  // namespace boresight
