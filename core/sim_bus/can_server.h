// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/can/can_link.h"
#include "core/sim/simulated_pair.h"
#include "core/sim_bus/due_queue.h"

#include <QObject>
#include <QTimer>

// The simulated pair on somebody else's bus, for instance a SocketCAN interface: answers what arrives on a CanLink.
// Lives on the link's thread. The pair follows the clock in real time while the server lives.
namespace boresight::sim {

class CanServer final : public QObject
{
    Q_OBJECT

public:
    // All three outlive the server; opening the link is its owner's business.
    CanServer(CanLink& link, SimulatedPair& pair, const Clock& clock, QObject* parent = nullptr);

private:
    void answer(const CanFrame& frame);
    void sendDue();
    [[nodiscard]] Seconds now() const { return m_begin + (m_clock.now() - m_epoch); }

    CanLink& m_link;
    SimulatedPair& m_pair;
    const Clock& m_clock;
    SteadyTime m_epoch;
    Seconds m_begin;  // the pair's time at the epoch
    DueQueue<CanFrame> m_replies;
    QTimer m_due;
    QTimer m_present;  // keeps the pair up with the clock
};

}  // namespace boresight::sim
