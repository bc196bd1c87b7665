// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/messages/power_status.h"
#include "core/mount/mount_driver.h"

#include <array>
#include <cstdint>
#include <optional>

// How much power the drives take, and what a motion has cost: from the tick in which the mount begins to slew, track or
// jog until it has stood for a few seconds. Power that is fed back into the supply counts negative. Only the time
// between two replies that follow each other is counted. Longer gaps are reported and not filled. Pure, station thread.
namespace boresight {

class EnergyMeter
{
public:
    // Once per tick. `errand`: a motion with another number is another one.
    void look(const MountDriver& mount, bool moves, std::uint64_t errand, SteadyTime now);

    [[nodiscard]] PowerStatus status() const;

private:
    struct Course
    {
        MotionEnergy energy;
        std::uint64_t errand = 0;
        SteadyTime began{};
        SteadyTime moved{};                // last
        std::array<Seconds, 2> counted{};  // of each axis
    };

    void take(const MountDriver& mount, SteadyTime now);
    void close();

    std::optional<double> m_total;
    std::array<std::optional<SteadyTime>, 2> m_heard;
    std::optional<Course> m_running;      // with what it costs to stand behind it
    std::optional<MotionEnergy> m_shown;  // of m_running, until it stood
    std::optional<MotionEnergy> m_last;
};

}  // namespace boresight
