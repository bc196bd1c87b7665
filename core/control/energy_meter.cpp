// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/control/energy_meter.h"

#include "core/messages/no_data.h"

#include <algorithm>
#include <utility>

namespace boresight {
namespace {

// Up to two lost replies in a row are bridged: the power of the next reply counts for the whole gap.
constexpr Seconds kLongestBridge{0.1};
// The mount stands between two targets of a stream for less than this.
constexpr Seconds kEndsAfter{5.0};

}  // namespace

void EnergyMeter::look(const MountDriver& mount, bool moves, std::uint64_t motionId, SteadyTime now)
{
    if (m_running && (moves ? m_running->motionId != motionId : now - m_running->moved > kEndsAfter)) {
        close();
    }
    if (moves && !m_running) {
        m_running = Course{.motionId = motionId, .began = now};
    }
    take(mount, now);
    if (m_running && moves) {
        m_running->moved = now;
        m_running->energy.time = now - m_running->began;
        const Seconds counted = std::min(m_running->counted[0], m_running->counted[1]);
        const Seconds unknown = m_running->energy.time - counted;
        m_running->energy.unknown = unknown > kLongestBridge ? unknown : Seconds{};
        m_shown = m_running->energy;
    }
}

void EnergyMeter::take(const MountDriver& mount, SteadyTime now)
{
    m_total = 0.0;
    for (const Axis axis : kAxes) {
        auto& heard = m_heard[index(axis)];
        const AxisReport report = mount.report(axis);
        if (!mount.capabilities().has(axis)) {
            heard = now;
            if (m_running) {
                m_running->counted[index(axis)] = now - m_running->began;
            }
            continue;
        }
        const bool fresh = report.power && report.heard && now - *report.heard < kNoDataAfter;
        m_total = fresh && m_total ? std::optional(*m_total + *report.power) : std::nullopt;
        const auto before = std::exchange(heard, report.heard);
        const Seconds gap = before && heard ? Seconds(*heard - *before) : Seconds{};
        if (m_running && report.power && gap > Seconds{} && gap <= kLongestBridge) {
            m_running->energy.joules += *report.power * gap.count();
            m_running->counted[index(axis)] += gap;
        }
    }
    if (m_running && m_total) {
        m_running->energy.peak = std::max(m_running->energy.peak, *m_total);
    }
}

// A motion without any power reading is not shown.
void EnergyMeter::close()
{
    if (m_shown && m_shown->unknown < m_shown->time) {
        m_last = m_shown;
    }
    m_running.reset();
    m_shown.reset();
}

PowerStatus EnergyMeter::status() const
{
    return {.total = m_total, .running = m_shown, .last = m_last};
}

}  // namespace boresight
