// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotator_box/switched_motors.h"

#include <algorithm>

namespace boresight {

SwitchedMotors::SwitchedMotors(const profile::InForce& profile, const Capabilities& capabilities,
                               const std::array<Angle, 2>& steps, Angle count)
    : m_profile(profile),
      m_capabilities(capabilities),
      m_steps(steps),
      m_count(count),
      m_axes{SwitchedAxis(habits(Axis::Azimuth)), SwitchedAxis(habits(Axis::Elevation))}
{}

SwitchedAxis::Habits SwitchedMotors::habits(Axis axis) const
{
    const profile::RotatorSettings& set = m_profile->rotator;
    return {.step = m_steps[index(axis)],
            .count = m_count,
            .mostStarts = set.mostStarts,
            .coast = set.coast > Angle{} ? std::optional(set.coast) : std::nullopt};
}

void SwitchedMotors::forget()
{
    for (SwitchedAxis& one : m_axes) {
        one.forget();
    }
}

void SwitchedMotors::begin()
{
    for (SwitchedAxis& one : m_axes) {
        one.begin();
    }
}

void SwitchedMotors::stopped(SteadyTime now)
{
    for (SwitchedAxis& one : m_axes) {
        one.stopped(now);
    }
}

// While one axis coasts, any target for it may switch its motor on again, so what can wait does.
SwitchedMotors::Targets SwitchedMotors::next(SteadyTime now)
{
    Targets targets;
    for (const Axis axis : kAxes) {
        of(axis).setHabits(habits(axis));
        const Axis other = axis == Axis::Azimuth ? Axis::Elevation : Axis::Azimuth;
        if (m_capabilities.has(axis)) {
            targets[index(axis)] = of(axis).next(leeway(axis), now, of(other).coasts());
        }
    }
    return targets;
}

SwitchedMotors::Targets SwitchedMotors::again(Axis axis)
{
    Targets targets;
    targets[index(axis)] = of(axis).again(leeway(axis));
    return targets;
}

RotatorTalk::Places SwitchedMotors::command(const Targets& targets) const
{
    const auto target = [&](Axis one) { return targets[index(one)] ? targets[index(one)] : axis(one).unchanged(); };
    return {.azimuth = target(Axis::Azimuth), .elevation = target(Axis::Elevation)};
}

void SwitchedMotors::sent(const Targets& targets, SteadyTime now)
{
    for (const Axis axis : kAxes) {
        if (const auto& target = targets[index(axis)]) {
            of(axis).sent(*target, now);
        }
    }
}

bool SwitchedMotors::stand() const
{
    return std::ranges::all_of(m_axes, [](const SwitchedAxis& one) { return one.stands(); });
}

}  // namespace boresight
