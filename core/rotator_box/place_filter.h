// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/units/quantity.h"

#include <optional>

// Decides which reported angles of one axis are believed. An answer that lost a digit on the line is a wrong number. So
// an angle that the axis cannot have reached since the last one counts only if the next one agrees with it. Then the
// position has jumped. Pure.
namespace boresight {

class PlaceFilter
{
public:
    // Faster than any such rotator turns. The potentiometer has noise of some degrees.
    static constexpr AngularRate kFastest = AngularRate::fromDegrees(25.0);
    static constexpr Angle kNoise = Angle::fromDegrees(3.0);

    // The position before and after the jump.
    struct Jump
    {
        Angle from;
        Angle to;
    };

    // Reads one angle. Returns a jump once. Empty if the angle is believed, or waits for the next one.
    [[nodiscard]] std::optional<Jump> take(Angle angle, SteadyTime now);
    // Forgets everything. The next position is believed only after two angles that agree.
    void forget() { *this = {}; }

    [[nodiscard]] const std::optional<Angle>& place() const { return m_place; }
    [[nodiscard]] SteadyTime placed() const { return m_placed; }

private:
    void believe(Angle angle, SteadyTime now);

    std::optional<Angle> m_place;
    std::optional<Angle> m_doubted;  // the last angle that was not believed
    SteadyTime m_placed{};
    SteadyTime m_taken{};
};

}  // namespace boresight
