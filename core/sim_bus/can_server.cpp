// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim_bus/can_server.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

namespace boresight::sim {

using namespace std::chrono_literals;

CanServer::CanServer(CanLink& link, SimulatedPair& pair, const Clock& clock, QObject* parent)
    : QObject(parent), m_link(link), m_pair(pair), m_clock(clock), m_epoch(clock.now()), m_begin(pair.now())
{
    m_due.setSingleShot(true);
    m_due.setTimerType(Qt::PreciseTimer);
    connect(&m_due, &QTimer::timeout, this, &CanServer::sendDue);
    connect(&m_present, &QTimer::timeout, this, [this] { m_pair.advanceTo(now()); });
    connect(&link, &CanLink::frameReceived, this, &CanServer::answer);
    m_present.start(100ms);
}

void CanServer::answer(const CanFrame& frame)
{
    for (const PairReply& reply : m_pair.exchange(frame, now())) {
        if (!reply.damaged) {  // a damaged frame only shows in the error counters of the controllers
            m_replies.add(reply.due, reply.frame);
        }
    }
    sendDue();
}

// A refusal is not handled here. The link reports it, and a real drive does not know either whether its frame arrived.
void CanServer::sendDue()
{
    std::vector<CanFrame> frames;
    while (const auto frame = m_replies.takeDue(now())) {
        frames.push_back(*frame);
    }
    if (!frames.empty()) {
        (void)m_link.send(frames);
    }
    if (const std::optional<Seconds> next = m_replies.nextDue()) {
        m_due.start(static_cast<int>(std::ceil(std::max((*next - now()).count(), 0.0) * 1000.0)));
    }
}

}  // namespace boresight::sim

#include "moc_can_server.cpp"
