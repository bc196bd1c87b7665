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

// The received power as a program tells it, one value per line (power_text.h): UDP datagrams that come to an address of
// this computer, or a TCP connection to that program. Nothing is ever sent. What cannot be opened or is lost is tried
// again after 1, 2, 4, 8 s, then each 10 s. At most kBytesAtOnce or kDatagramsAtOnce are read each kPause: some five
// values a second are plenty, and the rest waits at the sender or is dropped by the system. Lives in its owner's event
// loop.
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

// What happened so far. A plain value, so that it can be judged on another thread, at any later time.
struct LineState
{
    bool open = false;
    SteadyTime opened{};
    std::optional<Value> last{};
    QString trouble{};  // why it is not open; until the first value after that
    QString rubbish{};  // the first line since the last value that is none, and why
    std::uint64_t values = 0;
    std::uint64_t refused = 0;
};

// "UDP 127.0.0.1:4540"
[[nodiscard]] QString nameOf(const LineSettings& settings);
// What is wrong at `now`, in one sentence; empty: nothing. Pure.
[[nodiscard]] QString problemOf(const LineSettings& settings, const LineState& state, SteadyTime now);

class PowerLine : public QObject
{
    Q_OBJECT

public:
    static constexpr qint64 kBytesAtOnce = 4096;  // of TCP
    static constexpr int kDatagramsAtOnce = 50;
    static constexpr std::chrono::milliseconds kPause{10};

    // `clock` outlives the line.
    PowerLine(const LineSettings& settings, const Clock& clock, QObject* parent = nullptr);
    ~PowerLine() override;

    void open();
    [[nodiscard]] const LineState& state() const { return m_state; }
    [[nodiscard]] QString problem() const { return problemOf(m_settings, m_state, m_clock.now()); }

Q_SIGNALS:
    void received(const boresight::power::Value& value);
    // state() is another.
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
