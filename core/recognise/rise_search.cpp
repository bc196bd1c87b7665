// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognise/rise_search.h"

#include <cmath>

namespace boresight::recognise {
namespace {

constexpr double kGravity = 398600.4418;   // km³/s², of the Earth
constexpr double kRotation = 7.292115e-5;  // rad/s, of the Earth
constexpr std::chrono::seconds kStep{30};
constexpr double kFastest = 11.0;    // km/s: no satellite comes up faster
constexpr double kUpAlready = 50.0;  // km above the plane of the horizon

// Gravity, and the forces of the rotating frame.
orbit::Vector acceleration(const orbit::Vector& position, const orbit::Vector& velocity)
{
    const double distance = length(position);
    const orbit::Vector pull = (-kGravity / (distance * distance * distance)) * position;
    return pull + orbit::Vector{2.0 * kRotation * velocity.y + kRotation * kRotation * position.x,
                                -2.0 * kRotation * velocity.x + kRotation * kRotation * position.y, 0.0};
}

orbit::GroundState later(const orbit::GroundState& state, double time)
{
    const orbit::Vector first = acceleration(state.position, state.velocity);
    const orbit::GroundState middle{.position = state.position + (0.5 * time) * state.velocity,
                                    .velocity = state.velocity + (0.5 * time) * first};
    const orbit::Vector half = acceleration(middle.position, middle.velocity);
    return {.position = state.position + time * middle.velocity, .velocity = state.velocity + time * half};
}

}  // namespace

RoughRise::RoughRise(const orbit::Observer& observer)
    : m_observer(observer), m_site(observer.ground({}, 0.0)), m_up(observer.ground({{}, 90_deg}, 1.0) - m_site)
{}

std::optional<Rise> RoughRise::of(const orbit::GroundState& state, UtcTime now, UtcTime until) const
{
    orbit::GroundState there = state;
    if (height(there.position) > kUpAlready) {
        return std::nullopt;
    }
    for (UtcTime utc = now + kStep; utc <= until; utc += kStep) {
        if (height(there.position) < -kFastest * Seconds(until - utc + kStep).count()) {
            return std::nullopt;
        }
        there = later(there, Seconds(kStep).count());
        if (height(there.position) > 0.0) {
            return Rise{.utc = utc, .unit = unitOf(m_observer.look(there).direction)};
        }
    }
    return std::nullopt;
}

std::optional<Rise> exactRise(const UnitAt& unitAt, UtcTime from, UtcTime until)
{
    const auto isUp = [&](UtcTime utc) -> std::optional<bool> {
        const auto unit = unitAt(utc);
        return unit ? std::optional(unit->z > 0.0) : std::nullopt;
    };
    const auto before = isUp(from);
    const auto after = isUp(until);
    if (!before || *before || !after || !*after) {
        return std::nullopt;
    }
    while (until - from > std::chrono::milliseconds(100)) {
        const UtcTime middle = from + (until - from) / 2;
        const auto up = isUp(middle);
        if (!up) {
            return std::nullopt;
        }
        (*up ? until : from) = middle;
    }
    const auto unit = unitAt(until);
    return unit ? std::optional(Rise{.utc = until, .unit = *unit}) : std::nullopt;
}

}  // namespace boresight::recognise
