// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/request.h"
#include "core/messages/station_status.h"
#include "core/tuning/tuning_plan.h"

#include <optional>
#include <vector>

// A tuning run in progress: the motion that it needs in this tick, its recording, and the reasons that end it early.
// Pure: it sends no requests itself. Mechanical angles.
namespace boresight {

class TuningRunState
{
public:
    TuningRunState(TuningRun run, Axis axis, TuningWay way, const AxisPosition& here, SteadyTime now);

    // Once per tick. `sample`: set-point and position of the axis in the last tick. Empty: the last request stays.
    [[nodiscard]] std::optional<Request> step(SteadyTime now, const AxisSample& sample);

    [[nodiscard]] bool done() const { return m_leg == m_way.legs.size(); }
    // Why the run can not continue: the axis does not follow, or is held. Empty if it can continue.
    [[nodiscard]] QString obstacle(SteadyTime now) const;
    [[nodiscard]] TuningRun run() const { return m_run; }
    [[nodiscard]] Axis axis() const { return m_axis; }
    [[nodiscard]] double part(SteadyTime now) const;  // 0…1
    [[nodiscard]] Seconds left(SteadyTime now) const;
    [[nodiscard]] const std::vector<std::vector<response::Sample>>& parts() const { return m_parts; }
    [[nodiscard]] const std::vector<response::Sample>& all() const { return m_all; }

private:
    [[nodiscard]] const TuningLeg& leg() const { return m_way.legs[m_leg]; }
    [[nodiscard]] Request motionOf(SteadyTime now, const AxisSample& sample) const;
    void record(SteadyTime now, const AxisSample& sample);
    [[nodiscard]] bool isOver(SteadyTime now, const AxisSample& sample);
    void enter(std::size_t leg, SteadyTime now);

    TuningRun m_run;
    Axis m_axis;
    TuningWay m_way;
    AxisPosition m_here;  // the other axis stays there
    SteadyTime m_began;
    std::size_t m_leg = 0;
    SteadyTime m_legBegan;
    std::optional<SteadyTime> m_arrived;  // when the set-point arrived at the place of this leg
    bool m_asked = false;                 // the request for the place of this leg was sent
    Angle m_error;                        // the last following error
    std::vector<std::vector<response::Sample>> m_parts;
    std::vector<response::Sample> m_all;
};

}  // namespace boresight
