// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/bus_name.h"

#include <QObject>
#include <QProcess>
#include <QTimer>

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

// A rotctld that Boresight starts for a model of Hamlib, without a shell. It listens on this computer only, on a free
// port. It ends with Boresight, also where Boresight is killed. Station thread only.
namespace boresight::rotctl {

struct HamlibRotator
{
    BusName bus;                          // a Hamlib bus of the profile, with its model
    int baud = 0;                         // of its serial port
    std::vector<std::string> settings{};  // of Hamlib: "min_az=-90"
};

class OwnRotctld final : public QObject
{
    Q_OBJECT

public:
    static constexpr std::chrono::seconds kStartTime{10};  // some models query their rotator first
    // Within this time the program carries out its last two commands, of which the last is a stop. A SPID at 600 Bd
    // takes 0.8 s.
    static constexpr std::chrono::seconds kLastOrder{2};
    static constexpr std::chrono::milliseconds kLastWords{300};  // time in which an ended program reports its error

    OwnRotctld(HamlibRotator rotator, QObject* parent);
    ~OwnRotctld() override;

    [[nodiscard]] bool runs() const { return m_process.state() != QProcess::NotRunning; }
    // Does nothing if a program still runs.
    void start();
    // Ends the program after the time for its last command. Then it is killed, because a hanging program does not end
    // otherwise.
    void end();
    // The connection to the program is lost. Usually the program has ended, and its own error text arrives soon.
    // Otherwise it is killed.
    void connectionLost() { m_limit.start(kLastWords); }

Q_SIGNALS:
    // The program listens on this port. It is our program: the port was compared with its open files.
    void listens(quint16 port);
    // Why the program ended or did not start. Not emitted after end().
    void failed(const QString& reason);

private:
    void look();
    void keepErrors();
    void finish();
    void limitReached();
    void fail(const QString& reason);
    // How the program ended by itself, and why.
    [[nodiscard]] QString howItEnded() const;
    // The end of its error output, after a colon. Empty if it printed nothing.
    [[nodiscard]] QString lastWords() const;

    const HamlibRotator m_rotator;
    QProcess m_process{this};
    QTimer m_look{this};   // until the program listens
    QTimer m_limit{this};  // for the start of the program, then for its end
    QByteArray m_errors;   // the end of its error output
    quint16 m_port = 0;
    bool m_ending = false;
};

}  // namespace boresight::rotctl
