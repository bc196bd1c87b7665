// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/messages/power_status.h"
#include "core/mount/mount_driver.h"

#include <array>
#include <cstdint>
#include <optional>

// How much power the drives take, and how much energy a motion took. A motion counts from the tick in which the mount
// begins to slew, track or jog until it has stood for a few seconds. Power that is fed back into the supply counts as
// negative. Only the time between two consecutive replies is counted. Longer gaps are reported and not filled in.
// Pure, station thread.
namespace boresight {

class EnergyMeter
{
public:
    // Once per tick. Another motion id begins a new motion.
    void look(const MountDriver& mount, bool moves, std::uint64_t motionId, SteadyTime now);

    [[nodiscard]] PowerStatus status() const;

private:
    struct Course
    {
        MotionEnergy energy;
        std::uint64_t motionId = 0;
        SteadyTime began{};
        SteadyTime moved{};                // when it last moved
        std::array<Seconds, 2> counted{};  // the time of each axis for which the power is known
    };

    void take(const MountDriver& mount, SteadyTime now);
    void close();

    std::optional<double> m_total;
    std::array<std::optional<SteadyTime>, 2> m_heard;
    std::optional<Course> m_running;      // also counts the energy after the mount last moved
    std::optional<MotionEnergy> m_shown;  // m_running as it was when the mount last moved
    std::optional<MotionEnergy> m_last;
};

}  // namespace boresight
