// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/link_scan.h"

#include <chrono>

namespace boresight::app {
namespace {

using namespace std::chrono_literals;

// Differs from the source number of a station, so that on a shared bus neither receives the other's answers.
constexpr std::uint8_t kSource = 0x70;
constexpr auto kStep = 3ms;

}  // namespace

LinkScan::LinkScan(CanLink& link, QObject* parent)
    : QObject(parent), m_link(link), m_scan(kSource, {moteus::versionQuery(), moteus::rotatorQuery()})
{
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, &LinkScan::step);
    connect(&m_link, &CanLink::frameReceived, this, &LinkScan::take);
}

void LinkScan::start()
{
    m_timer.start(kStep);
    m_scan.begin(m_clock.now());
    step();
}

void LinkScan::step()
{
    const std::vector<CanFrame> frames = m_scan.frames(m_clock.now());
    if (!m_scan.isRunning()) {
        return end({});
    }
    if (frames.empty()) {
        return;
    }
    if (const Result<> sent = m_link.send(frames); !sent) {
        end(sent.error().text);
    }
}

void LinkScan::take(const CanFrame& frame)
{
    if (const Result<moteus::Reply> reply = moteus::decodeReply(frame)) {
        m_scan.take(*reply);
    }
}

void LinkScan::end(const QString& problem)
{
    if (m_timer.isActive()) {
        m_timer.stop();
        Q_EMIT finished(problem);
    }
}

}  // namespace boresight::app

#include "moc_link_scan.cpp"
