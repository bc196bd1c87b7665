// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/can/line_splitter.h"
#include "core/power/line_status.h"

#include <QObject>
#include <QTcpSocket>
#include <QTimer>
#include <QUdpSocket>

// The received power as a program tells it, one value per line (power_text.h): UDP datagrams that come to an address of
// this computer, or a TCP connection to that program. Nothing is ever sent. What cannot be opened or is lost is tried
// again after 1, 2, 4, 8 s, then each 10 s. Lives on the station thread.
namespace boresight::power {

enum class Transport
{
    Udp,
    Tcp
};

struct LineSettings
{
    Transport transport = Transport::Udp;
    QString host;
    std::uint16_t port = 0;
    std::chrono::milliseconds firstRetry{1000};
    std::chrono::milliseconds longestRetry{10000};
    Seconds silence{5.0};  // without a value: then it is said what comes in its place
};

struct Value
{
    double decibels = 0.0;
    SteadyTime arrival;
};

class PowerLine : public QObject
{
    Q_OBJECT

public:
    // `clock` outlives the line.
    PowerLine(const LineSettings& settings, const Clock& clock, QObject* parent = nullptr);
    ~PowerLine() override;

    void open();
    [[nodiscard]] LineStatus status() const;  // as it is now, by the clock

Q_SIGNALS:
    void received(const boresight::power::Value& value);

private:
    void listen();
    void connectToHost();
    void begin();
    void readDatagrams();
    void read(const QByteArray& bytes);
    void take(std::string_view line);
    void lose(const QString& reason);
    [[nodiscard]] QString problem() const;

    LineSettings m_settings;
    const Clock& m_clock;
    QString m_name;
    QUdpSocket m_udp{this};
    QTcpSocket m_tcp{this};
    fdcanusb::LineSplitter m_lines;
    QTimer m_retry{this};
    std::chrono::milliseconds m_delay;
    bool m_open = false;
    SteadyTime m_opened{};
    std::optional<Value> m_last;
    QString m_trouble;  // why it is not open; until the first value after that
    QString m_rubbish;  // the first line since the last value that is none, and why
    std::uint64_t m_values = 0;
    std::uint64_t m_refused = 0;
};

}  // namespace boresight::power
