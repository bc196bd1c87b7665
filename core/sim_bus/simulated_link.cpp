// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim_bus/simulated_link.h"

#include <QAbstractEventDispatcher>
#include <QThread>

#include <algorithm>
#include <cmath>

namespace boresight {

SimulatedLink::SimulatedLink(const Clock& clock, const sim::PairSettings& settings, QObject* parent)
    : SimulatedLink(clock, std::make_shared<SimulatedMount>(clock, settings), parent)
{}

SimulatedLink::SimulatedLink(const Clock& clock, std::shared_ptr<SimulatedMount> mount, QObject* parent)
    : CanLink(parent), m_clock(clock), m_mount(std::move(mount)), m_pair(m_mount->pair)
{
    m_timer.setSingleShot(true);
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, &SimulatedLink::deliver);
}

QString SimulatedLink::name() const
{
    return QStringLiteral("simulated");
}

Result<> SimulatedLink::open()
{
    setState(LinkState::Up, {});
    return {};
}

void SimulatedLink::close()
{
    m_timer.stop();
    m_replies.clear();
    setState(LinkState::Closed, {});
}

Result<> SimulatedLink::send(std::span<const CanFrame> frames)
{
    if (m_status.state == LinkState::Closed) {
        return failure(ErrorCode::NoDevice, QStringLiteral("the simulated bus is not open"));
    }
    m_pair.advanceTo(pairTime());
    if (isInjected(sim::FaultKind::BusOff)) {
        ++m_status.busErrors;
        setState(LinkState::Down, QStringLiteral("simulated: bus-off (injected)"));
        return failure(ErrorCode::Io, QStringLiteral("the simulated bus is off (injected)"));
    }
    setState(LinkState::Up, adapterTrouble());
    m_status.sent += frames.size();
    m_status.busErrors += m_status.text.isEmpty() ? 0 : frames.size();
    if (isInjected(sim::FaultKind::AdapterError)) {
        return {};  // a real adapter also refuses a frame only later, by ERR
    }
    const std::uint64_t collided = m_pair.replyCounts().collided;
    for (const CanFrame& frame : frames) {
        for (const sim::PairReply& reply : m_pair.exchange(frame, pairTime())) {
            m_replies.add(reply.due, reply);
        }
    }
    m_status.busErrors += m_pair.replyCounts().collided - collided;
    schedule();
    return {};
}

void SimulatedLink::deliver()
{
    m_pair.advanceTo(pairTime());
    while (auto reply = m_replies.takeDue(m_pair.now())) {
        if (reply->damaged) {
            ++m_status.dropped;
            continue;
        }
        ++m_status.received;
        reply->frame.received = m_clock.now();
        Q_EMIT frameReceived(reply->frame);
    }
    schedule();
}

sim::AxisTruth SimulatedLink::truth(Axis axis)
{
    return pair().truth(axis);
}

sim::SimulatedPair& SimulatedLink::pair()
{
    m_pair.advanceTo(pairTime());
    return m_pair;
}

sim::FaultSchedule::Handle SimulatedLink::inject(sim::Injection injection)
{
    injection.at = pair().now();
    return m_pair.faults().add(injection);
}

// For the faults of the adapter, which belong to no axis.
bool SimulatedLink::isInjected(sim::FaultKind kind) const
{
    return m_pair.faults().isActive(kind, Axis::Azimuth, m_pair.now());
}

QString SimulatedLink::adapterTrouble() const
{
    if (isInjected(sim::FaultKind::AdapterError)) {
        return QStringLiteral("simulated: the adapter refuses every frame (injected)");
    }
    return isInjected(sim::FaultKind::MissingOk)
               ? QStringLiteral("simulated: the adapter acknowledges nothing (injected)")
               : QString();
}

void SimulatedLink::setState(LinkState state, const QString& text)
{
    if (m_status.state == state && m_status.text == text) {
        return;
    }
    m_status.state = state;
    m_status.text = text;
    Q_EMIT statusChanged(m_status);
}

void SimulatedLink::schedule()
{
    const std::optional<Seconds> due = m_replies.nextDue();
    if (!due || QAbstractEventDispatcher::instance(thread()) == nullptr) {
        return;  // nothing to do, or no event loop: deliver() is called by hand
    }
    const double wait = std::max((*due - pairTime()).count(), 0.0);
    m_timer.start(static_cast<int>(std::ceil(wait * 1000.0)));
}

}  // namespace boresight

#include "moc_simulated_link.cpp"
