// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/can/can_link.h"
#include "core/sim/simulated_pair.h"
#include "core/sim_bus/due_queue.h"

#include <QObject>
#include <QTimer>

// The simulated pair on an existing bus, for instance on a SocketCAN interface. Answers the frames that arrive on a
// CanLink. Lives on the thread of the link. The time of the pair follows the clock while the server lives.
namespace boresight::sim {

class CanServer final : public QObject
{
    Q_OBJECT

public:
    // All three outlive the server. The owner of the link opens it.
    CanServer(CanLink& link, SimulatedPair& pair, const Clock& clock, QObject* parent = nullptr);

private:
    void answer(const CanFrame& frame);
    void sendDue();
    [[nodiscard]] Seconds now() const { return m_begin + (m_clock.now() - m_epoch); }

    CanLink& m_link;
    SimulatedPair& m_pair;
    const Clock& m_clock;
    SteadyTime m_epoch;
    Seconds m_begin;  // the time of the pair at m_epoch
    DueQueue<CanFrame> m_replies;
    QTimer m_due;
    QTimer m_present;  // moves the pair on with the clock
};

}  // namespace boresight::sim
