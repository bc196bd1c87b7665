// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/orbit/orbit_state.h"
#include "core/orbit/topocentric.h"
#include "core/recognise/moving_fit.h"

#include <optional>

// Finds where a body that is below the horizon rises within the next minutes. Pure.
namespace boresight::recognise {

struct Rise
{
    UtcTime utc;
    orbit::Vector unit;  // direction
};

// A fast forecast that leaves out most satellites: gravity of a round Earth only. Its error is some degrees and less
// than a minute.
class RoughRise
{
public:
    explicit RoughRise(const orbit::Observer& observer);

    // Empty: the satellite is up at `now`, or still down at `until`.
    [[nodiscard]] std::optional<Rise> of(const orbit::GroundState& state, UtcTime now, UtcTime until) const;

private:
    [[nodiscard]] double height(const orbit::Vector& position) const { return dot(m_up, position - m_site); }

    orbit::Observer m_observer;
    orbit::Vector m_site;
    orbit::Vector m_up;
};

// The exact rise between two times. Empty: the body is up at `from`, or still down at `until`.
[[nodiscard]] std::optional<Rise> exactRise(const UnitAt& unitAt, UtcTime from, UtcTime until);

}  // namespace boresight::recognise
