// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/sim/simulated_pair.h"
#include "core/sim_bus/fdcanusb_server.h"
#include "core/sim_bus/pseudo_terminal.h"

#include <QObject>
#include <QSocketNotifier>
#include <QString>
#include <QTimer>

#include <memory>

// The simulated pair as a device file: an fdcanusb adapter on a pseudo-terminal, with a symbolic link at a path that
// the user chooses. Lives on the thread of its event loop. Never blocks. A client may close the file and open it again.
// The link is removed with the server. The time of the pair follows the clock while the server lives.
namespace boresight::sim {

class PtyServer final : public QObject
{
    Q_OBJECT

public:
    // Clock and pair outlive the server. Refused if `link` exists and is not a symbolic link.
    [[nodiscard]] static Result<std::unique_ptr<PtyServer>> create(const QString& link, SimulatedPair& pair,
                                                                   const Clock& clock);

    [[nodiscard]] QString link() const { return m_terminal.link(); }
    [[nodiscard]] QString terminal() const { return m_terminal.device(); }
    // False after a client has closed, until the next client is found.
    [[nodiscard]] bool hasClient() const { return !m_absent.isActive(); }

private:
    PtyServer(PseudoTerminal terminal, SimulatedPair& pair, const Clock& clock);

    void read();
    void write(const std::string& bytes);
    void flush();
    void answerDue();
    void watchForClient();
    [[nodiscard]] Seconds now() const { return m_begin + (m_clock.now() - m_epoch); }

    PseudoTerminal m_terminal;
    SimulatedPair& m_pair;
    const Clock& m_clock;
    SteadyTime m_epoch;
    Seconds m_begin;  // the time of the pair at m_epoch
    FdcanusbServer m_server;
    QByteArray m_unsent;
    QSocketNotifier m_readable;
    QSocketNotifier m_writable;
    QTimer m_due;      // for delayed replies
    QTimer m_present;  // moves the pair on with the clock
    QTimer m_absent;   // looks for a client while there is none
};

}  // namespace boresight::sim
