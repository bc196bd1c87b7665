// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/units/sky.h"

#include <array>
#include <optional>

// A simulated rotator of the simplest kind: it accepts targets in whole degrees, moves there at one speed, and reports
// whole degrees. It has no rates, no watchdog and no torque. Its gears hold it when it stands still. Pure: time is
// passed in. Mechanical angles.
namespace boresight {

class SimpleBox
{
public:
    static constexpr AngularRate kSpeed = AngularRate::fromDegrees(6.0);
    static constexpr Angle kStep = Angle::fromDegrees(1.0);

    explicit SimpleBox(const AxisPosition& place = {}) : m_place{place.azimuth, place.elevation} {}

    // The commands of its control box. Without power they are lost, and the axes stand still.
    void goTo(Axis axis, Angle wholeDegrees, SteadyTime now);
    void stop(SteadyTime now);
    // Empty without power.
    [[nodiscard]] std::optional<AxisPosition> position(SteadyTime now);

    void setPower(bool on, SteadyTime now);
    // The true position.
    [[nodiscard]] AxisPosition truth() const { return {.azimuth = m_place[0], .elevation = m_place[1]}; }
    [[nodiscard]] int orders() const { return m_orders; }  // received so far

private:
    void moveOn(SteadyTime now);

    std::array<Angle, 2> m_place;
    std::array<std::optional<Angle>, 2> m_target;
    std::optional<SteadyTime> m_moved;
    bool m_powered = true;
    int m_orders = 0;
};

}  // namespace boresight
