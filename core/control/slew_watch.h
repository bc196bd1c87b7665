// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/messages/station_status.h"
#include "core/motion/course.h"
#include "core/motion/motion.h"
#include "core/units/sky.h"

#include <optional>
#include <vector>

// How a slew will go, and when it ends: looked up when it begins, and again when the motion leaves what was expected.
// Decides nothing about motion. Station thread only; mechanical angles.
namespace boresight {

class SlewWatch
{
public:
    // Once in a tick, after the set-points moved on. `slewing`: the mount is on its way to a target.
    void update(bool slewing, const Motion& motion, SteadyTime now);
    // What is permitted, or how fast the axes go, is another: the way is looked up again.
    void lookAgain() { m_look.reset(); }

    // Empty while the mount does not slew, and while nobody knows when it ends.
    [[nodiscard]] std::optional<SlewProgress> progress(SteadyTime now) const;
    // The way that is left, without where the set-points are; empty as above.
    [[nodiscard]] std::vector<AxisPosition> way(SteadyTime now) const;

private:
    [[nodiscard]] bool isAsExpected(const Motion& motion, const AxisPosition& target, SteadyTime now) const;

    struct Look
    {
        SteadyTime when{};
        std::optional<Course> course;  // from then on; empty: it does not get there
    };

    std::optional<AxisPosition> m_target;  // as it was last; empty: no slew
    SteadyTime m_began{};
    std::optional<Look> m_look;
};

}  // namespace boresight
