// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/bus_name.h"

#include <QObject>
#include <QProcess>
#include <QTimer>

#include <chrono>
#include <cstdint>

// A rotctld that Boresight starts for a model of Hamlib, without a shell. It listens on this computer only, on a free
// port. It ends with Boresight, also where Boresight is killed. Station thread only.
namespace boresight::rotctl {

class OwnRotctld final : public QObject
{
    Q_OBJECT

public:
    static constexpr std::chrono::seconds kStartTime{10};  // some models ask their rotator first
    // In which it carries out the order before the last and the last, a stop: 0.8 s for a SPID at 600 Bd.
    static constexpr std::chrono::seconds kLastOrder{2};
    static constexpr std::chrono::milliseconds kLastWords{300};  // in which one that has ended reports why

    // `bus` as the profile names it, with a model; `baud` as bits per second of its serial port.
    OwnRotctld(BusName bus, int baud, QObject* parent);
    ~OwnRotctld() override;

    [[nodiscard]] bool runs() const { return m_process.state() != QProcess::NotRunning; }
    // Nothing where one still runs.
    void start();
    // After the time for its last order. Then it is killed: one that hangs does not end otherwise.
    void end();
    // The connection to it is lost. As a rule it has ended, which its own words say better. Else it is killed.
    void connectionLost() { m_limit.start(kLastWords); }

Q_SIGNALS:
    // It listens there. Nobody else does: the port was compared with its own files.
    void listens(quint16 port);
    // Why it does not run any more, or never did. Not after end().
    void failed(const QString& reason);

private:
    void look();
    void keepErrors();
    void finish();
    void limitReached();
    void fail(const QString& reason);
    // The end of what it printed of its trouble, after a colon. Empty: nothing.
    [[nodiscard]] QString lastWords() const;

    const BusName m_bus;
    const int m_baud;
    QProcess m_process{this};
    QTimer m_look{this};   // until it listens
    QTimer m_limit{this};  // of its start, then of its end
    QByteArray m_errors;   // the last bytes
    quint16 m_port = 0;
    bool m_ending = false;
};

}  // namespace boresight::rotctl
