// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/units/quantity.h"

#include <optional>

// What of the reported angles of one axis is believed. An answer that lost a digit on the line is a wrong number, so an
// angle that cannot have been reached since the last one counts only when the next one agrees with it: then the
// rotator has jumped. Pure.
namespace boresight {

class PlaceFilter
{
public:
    // Faster than any such rotator turns. Its potentiometer is noisy by some degrees.
    static constexpr AngularRate kFastest = AngularRate::fromDegrees(25.0);
    static constexpr Angle kNoise = Angle::fromDegrees(3.0);

    // Where it was and where it is now.
    struct Jump
    {
        Angle from;
        Angle to;
    };

    // Empty: all is well, or it waits for the next one.
    [[nodiscard]] std::optional<Jump> take(Angle angle, SteadyTime now);
    // The next two begin again.
    void forget() { *this = {}; }

    [[nodiscard]] const std::optional<Angle>& place() const { return m_place; }
    [[nodiscard]] SteadyTime placed() const { return m_placed; }

private:
    void believe(Angle angle, SteadyTime now);

    std::optional<Angle> m_place;
    std::optional<Angle> m_doubted;  // the last one, not believed
    SteadyTime m_placed{};
    SteadyTime m_taken{};
};

}  // namespace boresight
