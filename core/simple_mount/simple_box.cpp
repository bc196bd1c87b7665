// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simple_mount/simple_box.h"

#include <algorithm>
#include <cmath>

namespace boresight {
namespace {

Angle whole(Angle angle)
{
    return Angle::fromDegrees(std::round(angle.degrees()));
}

}  // namespace

void SimpleBox::moveOn(SteadyTime now)
{
    const Seconds time = m_moved ? Seconds(now - *m_moved) : Seconds(0.0);
    m_moved = now;
    for (const Axis axis : kAxes) {
        std::optional<Angle>& target = m_target[index(axis)];
        Angle& place = m_place[index(axis)];
        if (!m_powered || !target) {
            continue;
        }
        const Angle farthest = kSpeed * time;
        place = std::clamp(*target, place - farthest, place + farthest);
        if (place == *target) {
            target.reset();
        }
    }
}

void SimpleBox::goTo(Axis axis, Angle wholeDegrees, SteadyTime now)
{
    moveOn(now);
    if (m_powered) {
        m_target[index(axis)] = whole(wholeDegrees);
        ++m_orders;
    }
}

void SimpleBox::stop(SteadyTime now)
{
    moveOn(now);
    if (m_powered) {
        m_target = {};
        ++m_orders;
    }
}

std::optional<AxisPosition> SimpleBox::position(SteadyTime now)
{
    moveOn(now);
    if (!m_powered) {
        return std::nullopt;
    }
    return AxisPosition{.azimuth = whole(m_place[0]), .elevation = whole(m_place[1])};
}

// The box forgets its targets.
void SimpleBox::setPower(bool on, SteadyTime now)
{
    moveOn(now);
    m_powered = on;
    m_target = {};
}

}  // namespace boresight
