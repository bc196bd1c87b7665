// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/sim/fault_injection.h"
#include "core/sim/power_supply.h"
#include "core/sim/reply_spoiler.h"
#include "core/sim/simulated_moteus.h"
#include "core/units/sky.h"

#include <array>
#include <memory>
#include <optional>
#include <random>
#include <vector>

// The simulated mount: two moteus with their axes on one supply and one bus. Pure, without a clock of its own. Its time
// is in seconds since it was made, and only advanceTo() and exchange() move it on. All steps have the same length, so
// the same calls always give the same run.
namespace boresight::sim {

struct PairSettings
{
    MoteusSettings azimuth;
    MoteusSettings elevation;
    // A third board on the bus and on the supply, with an id of its own. It has no injected faults.
    std::optional<MoteusSettings> third = std::nullopt;
    SupplySettings supply{};
    std::uint32_t seed = 1;  // for lost and edited frames
    // How often (0…1) two different answers with one id destroy each other. Otherwise one board begins later and waits,
    // and both answers arrive.
    double collisions = 1.0;
};

// The reference mount (reference_mount.h) with referenced and protected drives. The axes are at `start`.
[[nodiscard]] PairSettings commissionedPair(const AxisPosition& start = {.azimuth = 0.0_deg, .elevation = 10.0_deg});
// The same mechanics with new boards: both have id 1, ratio 1, bounds ±0.01 turns, and are not referenced.
[[nodiscard]] PairSettings factoryPair(const AxisPosition& start = {.azimuth = 0.0_deg, .elevation = 10.0_deg});

// The drive of the feed (reference_mount.h), referenced and protected, with its axis in the middle of its travel.
[[nodiscard]] MoteusSettings commissionedFeed(int id);

// The true state of an axis, which the reports of the drive may contradict.
struct AxisTruth
{
    Angle angle;  // of the antenna, behind the backlash
    AngularRate rate;
    double torque = 0.0;   // Nm of the drive on the axis, towards larger angles
    double current = 0.0;  // A
    moteus::Mode mode = moteus::Mode::Stopped;
    int faultCode = 0;
    bool powered = true;
};

// An end switch of the simulated mount, wired to a pin of one of its boards.
struct WiredSwitch
{
    Axis board = Axis::Azimuth;  // named by the axis that it turns
    int port = 1;
    int pin = 0;
    Axis axis = Axis::Azimuth;  // the axis that presses the switch
    double at = 0.0;            // turns of its drive
    bool isAbove = true;        // pressed from there on upwards, else downwards
    bool isHighWhenPressed = false;
};

// One reply on the bus to a frame.
struct PairReply
{
    CanFrame frame;
    Seconds due{0.0};      // when the reply arrives
    bool damaged = false;  // the adapter must garble the reply
};

// Replies since the pair was made, counted by the drives.
struct ReplyCounts
{
    std::uint64_t said = 0;
    std::uint64_t lost = 0;      // of the sent replies: lost by injected faults
    std::uint64_t collided = 0;  // of the sent replies: destroyed by another answer with the same id
};

class SimulatedPair
{
public:
    explicit SimulatedPair(const PairSettings& settings);

    void advanceTo(Seconds now);
    [[nodiscard]] Seconds now() const { return m_now; }

    // Puts one frame on the bus at `now`, after advancing to that time. Returns the replies in the order of
    // arbitration.
    [[nodiscard]] std::vector<PairReply> exchange(const CanFrame& frame, Seconds now);

    void wire(const WiredSwitch& one);
    [[nodiscard]] SimulatedMoteus& third() { return *m_third; }  // only if the settings have one
    // A drive that is not fitted neither receives nor sends. At first both are fitted.
    void setFitted(Axis axis, bool fitted) { m_sides[side(axis)].fitted = fitted; }

    [[nodiscard]] AxisTruth truth(Axis axis) const;
    [[nodiscard]] FaultSchedule& faults() { return m_faults; }
    [[nodiscard]] const FaultSchedule& faults() const { return m_faults; }
    [[nodiscard]] SimulatedMoteus& drive(Axis axis) { return *m_sides[side(axis)].drive; }
    [[nodiscard]] double busVoltage() const { return m_supply.voltage(); }
    [[nodiscard]] const ReplyCounts& replyCounts() const { return m_replyCounts; }

private:
    struct Side
    {
        Axis axis;
        std::unique_ptr<SimulatedMoteus> drive;
        ReplySpoiler spoiler;
        bool fitted = true;
        int injectedFault = 0;
        double injectedSlip = 0.0;          // degrees
        std::optional<double> handAngle{};  // degrees, while the power is off
    };

    static std::size_t side(Axis axis) { return axis == Axis::Azimuth ? 0 : 1; }
    void step(double dt);
    void press();
    void applyFaults();
    void applyFaults(Side& side);
    void applyPower();
    [[nodiscard]] double faultValue(FaultKind kind, Axis axis, double otherwise) const;
    [[nodiscard]] bool happens(FaultKind kind, Axis axis);
    struct Answer
    {
        Side* side = nullptr;
        CanFrame frame;
    };
    [[nodiscard]] std::vector<Answer> ask(const CanFrame& frame);
    [[nodiscard]] std::optional<CanFrame> askOne(Side& side, const CanFrame& frame);
    [[nodiscard]] int otherId(const Side& side) const;

    PowerSupply m_supply;
    double m_supplyVoltage;
    double m_collisions;
    std::array<Side, 2> m_sides;
    std::unique_ptr<SimulatedMoteus> m_third;  // null: there is none
    std::vector<WiredSwitch> m_switches;
    FaultSchedule m_faults;
    ReplyCounts m_replyCounts;
    std::minstd_rand m_random;
    Seconds m_now{0.0};
    Seconds m_stepped{0.0};        // at most one step before m_now
    bool m_faultsApplied = false;  // faults must be undone when the schedule is empty
};

}  // namespace boresight::sim
