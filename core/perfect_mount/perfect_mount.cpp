// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/perfect_mount/perfect_mount.h"

#include "core/base/text.h"

#include <algorithm>
#include <utility>

namespace boresight {
namespace {

std::optional<AxisCapabilities> capabilitiesIn(const AxisSet& axes, Axis axis)
{
    constexpr AxisCapabilities kPerfect{.silence = Seconds(1.0), .watchdog = true};
    return std::ranges::find(axes, axis) != axes.end() ? std::optional(kPerfect) : std::nullopt;
}

}  // namespace

PerfectMount::PerfectMount(const AxisSet& axes, const AxisPosition& standing)
    : m_capabilities{.axes = {capabilitiesIn(axes, Axis::Azimuth), capabilitiesIn(axes, Axis::Elevation)}},
      m_names{QStringLiteral("azimuth drive"), QStringLiteral("elevation drive")}
{
    m_setpoints[index(Axis::Azimuth)].position = standing.azimuth;
    m_setpoints[index(Axis::Elevation)].position = standing.elevation;
}

QString PerfectMount::label(Axis axis) const
{
    return Text::of(name(axis).toStdString());
}

AxisReport PerfectMount::report(Axis axis) const
{
    if (!m_capabilities.has(axis)) {
        return reportOfMissingAxis(m_follows, m_now);
    }
    return {.hand = m_follows ? AxisHand::Follows : AxisHand::HoldsItself,
            .answers = true,
            .seen = true,
            .changesHands = m_wanted && !m_follows,
            .underOrders = m_follows || m_wanted,
            .wrapKnown = true,
            .place = m_setpoints[index(axis)].position,
            .placed = m_now,
            .rate = m_setpoints[index(axis)].rate,
            .heard = m_now};
}

MountFindings PerfectMount::supervise(const MountSituation& /*known*/)
{
    if (m_wanted && !m_follows) {
        m_follows = true;
        m_begins = {true, true};
    }
    return {};
}

std::optional<Angle> PerfectMount::takeFollowing(Axis axis)
{
    return std::exchange(m_begins[index(axis)], false) ? report(axis).place : std::nullopt;
}

}  // namespace boresight
