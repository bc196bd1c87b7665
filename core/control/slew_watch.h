// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/messages/station_status.h"
#include "core/motion/course.h"
#include "core/motion/motion.h"
#include "core/units/sky.h"

#include <optional>
#include <vector>

// Predicts the way of a slew and its end. Computes them when the slew begins, and again when the motion differs from
// the prediction. Decides nothing about motion. Station thread only; mechanical angles.
namespace boresight {

class SlewWatch
{
public:
    // Once in a tick, after the set-points were moved. `slewing`: the mount is on its way to a target.
    void update(bool slewing, const Motion& motion, SteadyTime now);
    // The permitted region or the speed limits changed. The way is computed again.
    void lookAgain() { m_look.reset(); }

    // Empty while the mount does not slew, and while the end of the slew is unknown.
    [[nodiscard]] std::optional<SlewProgress> progress(SteadyTime now) const;
    // The way that is left, without its first point, the set-points. Empty in the same cases as progress().
    [[nodiscard]] std::vector<AxisPosition> way(SteadyTime now) const;

private:
    [[nodiscard]] bool isAsExpected(const Motion& motion, const AxisPosition& target, SteadyTime now) const;

    struct Look
    {
        SteadyTime when{};
        std::optional<Course> course;  // from `when` on; empty: the slew does not reach the target
    };

    std::optional<AxisPosition> m_target;  // of the last tick; empty: no slew
    SteadyTime m_began{};
    std::optional<Look> m_look;
};

}  // namespace boresight
