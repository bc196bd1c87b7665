// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simple_mount/simple_mount.h"

#include "core/base/text.h"

#include <cmath>

namespace boresight {
namespace {

Angle wholeDegrees(Angle angle)
{
    return Angle::fromDegrees(std::round(angle.degrees()));
}

std::optional<AxisCapabilities> capabilitiesOf(bool present)
{
    // Slower than the box, so that the box keeps up with the set-points.
    constexpr AxisCapabilities kAxis{.step = SimpleBox::kStep,
                                     .fastest = AngularRate::fromDegrees(0.9 * SimpleBox::kSpeed.degrees()),
                                     .silence = SimpleMount::kSilence};
    return present ? std::optional(kAxis) : std::nullopt;
}

}  // namespace

SimpleMount::SimpleMount(SimpleBox& box, const Axes& axes)
    : m_box(box),
      m_capabilities{.axes = {capabilitiesOf(axes.azimuth), capabilitiesOf(axes.elevation)}},
      m_names{QStringLiteral("azimuth drive"), QStringLiteral("elevation drive")}
{}

QString SimpleMount::label(Axis axis) const
{
    return Text::of(name(axis).toStdString());
}

// Such a box has no identity that can be read.
std::optional<QString> SimpleMount::identity(Axis /*axis*/) const
{
    return m_heard ? std::optional(QString()) : std::nullopt;
}

AxisReport SimpleMount::report(Axis axis) const
{
    if (!m_capabilities.has(axis)) {
        return reportOfMissingAxis(m_follows, m_now);
    }
    AxisReport report{.hand = m_follows ? AxisHand::Follows : AxisHand::HoldsItself,
                      .answers = answers(),
                      .seen = answers(),
                      .latched = m_lost,
                      .changesHands = m_wanted && !m_follows,
                      .underOrders = m_follows || m_wanted,
                      .wrapKnown = m_heard.has_value()};
    if (m_place) {
        report.place = axis == Axis::Azimuth ? m_place->azimuth : m_place->elevation;
        report.placed = *m_heard;
        report.heard = m_heard;
    }
    return report;
}

void SimpleMount::observe(SteadyTime now)
{
    m_now = now;
    if (const auto place = m_box.position(now)) {
        if (m_lost && !answers()) {
            m_box.stop(now);  // it may still be moving to a target from before the silence
        }
        m_place = place;
        m_heard = now;
    }
}

void SimpleMount::letGo()
{
    m_follows = false;
    m_wanted = false;
    m_begins = {};
    m_ordered = {};
}

MountFindings SimpleMount::supervise(const MountSituation& /*known*/)
{
    MountFindings found;
    if (m_follows && !answers()) {
        letGo();
        m_lost = true;
        for (const Axis axis : kAxes) {
            if (m_capabilities.has(axis)) {
                found.troubles.push_back({.axis = axis,
                                          .loss = supervision::LossClass::Bus,
                                          .what = Text::tr("the %1 stopped replying").arg(label(axis))});
            }
        }
    }
    if (m_wanted && !m_follows && answers()) {
        m_follows = true;
        m_begins = {true, true};
        m_ordered = {m_place->azimuth, m_place->elevation};
    }
    return found;
}

std::optional<Angle> SimpleMount::takeFollowing(Axis axis)
{
    return std::exchange(m_begins[index(axis)], false) ? report(axis).place : std::nullopt;
}

void SimpleMount::send()
{
    if (!m_follows) {
        return;
    }
    for (const Axis axis : kAxes) {
        const Angle wanted = wholeDegrees(m_setpoints[index(axis)].position);
        std::optional<Angle>& ordered = m_ordered[index(axis)];
        if (m_capabilities.has(axis) && wanted != ordered) {
            m_box.goTo(axis, wanted, m_now);
            ordered = wanted;
        }
    }
}

// The box moves although it does not follow: it carries out an old command, or somebody uses its keys.
void SimpleMount::seize()
{
    if (!m_follows && answers()) {
        m_box.stop(m_now);
    }
}

void SimpleMount::leave(profile::OnExit /*how*/)
{
    if (m_follows) {
        m_box.stop(m_now);
        letGo();
    }
}

}  // namespace boresight
