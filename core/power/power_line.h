// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/serial/line_splitter.h"

#include <QObject>
#include <QString>
#include <QTcpSocket>
#include <QTimer>
#include <QUdpSocket>

#include <cstdint>
#include <optional>

// Receives the power that another program reports, one value per line (power_text.h). The lines arrive in UDP datagrams
// at an address of this computer, or by a TCP connection to the program. Boresight sends nothing. If the socket cannot
// be opened or the connection is lost, Boresight retries after 1, 2, 4, 8 s, then every 10 s. At most kBytesAtOnce or
// kDatagramsAtOnce are read in each kPause: five values a second are enough. The rest waits at the sender, or the
// operating system drops it. Lives in the event loop of its owner.
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
    Seconds silence{5.0};  // after this time without a value, problemOf() reports it
};

struct Value
{
    double decibels = 0.0;
    SteadyTime arrival;
};

// The events of the line so far. A plain value, so that another thread can judge it at a later time.
struct LineState
{
    bool open = false;
    SteadyTime opened{};
    std::optional<Value> last{};
    QString trouble{};  // why the line could not be opened or was lost; cleared by the next value
    QString rubbish{};  // the first line since the last value that was refused, with the reason
    std::uint64_t values = 0;
    std::uint64_t refused = 0;
};

// "UDP 127.0.0.1:4540"
[[nodiscard]] QString nameOf(const LineSettings& settings);
// The problem of the line at `now`. Empty if there is none. Pure.
[[nodiscard]] QString problemOf(const LineSettings& settings, const LineState& state, SteadyTime now);

class PowerLine : public QObject
{
    Q_OBJECT

public:
    static constexpr qint64 kBytesAtOnce = 4096;  // of TCP
    static constexpr int kDatagramsAtOnce = 50;
    static constexpr std::chrono::milliseconds kPause{10};

    // `clock` must outlive the line.
    PowerLine(const LineSettings& settings, const Clock& clock, QObject* parent = nullptr);
    ~PowerLine() override;

    void open();
    [[nodiscard]] const LineState& state() const { return m_state; }
    [[nodiscard]] QString problem() const { return problemOf(m_settings, m_state, m_clock.now()); }

Q_SIGNALS:
    void received(const boresight::power::Value& value);
    // state() has changed.
    void stateChanged();

private:
    void listen();
    void connectToHost();
    void begin();
    void readSome();
    [[nodiscard]] bool readDatagrams();
    [[nodiscard]] bool readStream();
    void read(const QByteArray& bytes);
    void take(std::string_view line);
    void lose(const QString& reason);

    LineSettings m_settings;
    const Clock& m_clock;
    QUdpSocket m_udp{this};
    QTcpSocket m_tcp{this};
    LineSplitter m_lines;
    QTimer m_retry{this};
    QTimer m_pause{this};
    std::chrono::milliseconds m_delay;
    LineState m_state;
    std::uint64_t m_refused = 0;  // without the lines that were too long
};

}  // namespace boresight::power
