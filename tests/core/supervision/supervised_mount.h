// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/moteus/codec.h"
#include "core/profile/profile.h"
#include "core/sim/simulated_pair.h"
#include "core/supervision/axis_supervisor.h"
#include "core/supervision/place_belief.h"
#include "core/tracking/axis_setpoints.h"

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

// The loop of a station on a small scale: two supervised axes on the simulated pair with all its physics, ticked by
// hand at 50 Hz. It ignores the findings, so that a test sees all of them. Times are seconds since its construction.
namespace boresight::supervision {

// The first time of a finding with this weight.
struct Found
{
    Seconds at{0.0};
    Axis axis = Axis::Azimuth;
    Observed observed;
};

class SupervisedMount
{
public:
    static constexpr Seconds kTick{0.02};

    explicit SupervisedMount(const sim::PairSettings& pair = sim::commissionedPair(),
                             const profile::Profile& profile = {});

    void run(Seconds time);
    // Set-points start at the positions of the axes. Both axes stand still until they are commanded.
    void engage();
    void release();  // switches the drives off
    void goTo(Axis axis, Angle target);
    void turn(Axis axis, AngularRate rate);  // with rate 0 the axis comes to a standstill
    void send(Axis axis, const moteus::Command& command);

    sim::FaultSchedule::Handle inject(sim::FaultKind kind, Axis axis, std::optional<double> value = {},
                                      Seconds duration = Seconds(1e9));
    void end(sim::FaultSchedule::Handle handle) { m_pair.faults().remove(handle); }

    [[nodiscard]] sim::SimulatedPair& pair() { return m_pair; }
    [[nodiscard]] Seconds now() const { return m_now; }
    [[nodiscard]] AxisSupervisor& supervisor(Axis axis) { return side(axis).supervisor; }
    [[nodiscard]] const AxisObservation& seen(Axis axis) { return side(axis).seen; }

    [[nodiscard]] const std::vector<Found>& found() const { return m_found; }
    [[nodiscard]] std::optional<Found> first(Symptom symptom, Weight weight) const;
    [[nodiscard]] bool stopped() const;        // whether there is any finding that stops the mount
    [[nodiscard]] std::string report() const;  // for a failed test
    void clearFound() { m_found.clear(); }

    std::function<void()> onTick;

private:
    struct Side
    {
        Axis axis;
        const profile::AxisSettings& settings;
        tracking::AxisSetpoints setpoints;
        AxisSupervisor supervisor;
        PlaceBelief belief;
        SteadyTime asked{};
        AxisObservation seen{};
        std::optional<Angle> target{};
        AngularRate rate{};
    };

    [[nodiscard]] Side& side(Axis axis) { return m_sides[axis == Axis::Azimuth ? 0 : 1]; }
    void tick();
    void takeReplies();
    void take(const moteus::Reply& reply, Seconds received);
    void judge(Side& side);
    void command(Side& side);
    void exchange(Axis axis, const std::optional<moteus::Command>& command);

    profile::Profile m_profile;
    profile::InForce m_inForce{m_profile};
    sim::SimulatedPair m_pair;
    std::array<Side, 2> m_sides;
    std::vector<sim::PairReply> m_replies;
    std::vector<Found> m_found;
    Seconds m_now{0.0};
};

}  // namespace boresight::supervision
