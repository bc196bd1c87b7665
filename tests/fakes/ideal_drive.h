// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/can_frame.h"
#include "core/moteus/codec.h"
#include "core/units/quantity.h"

#include <array>
#include <cstddef>
#include <deque>
#include <optional>
#include <utility>
#include <vector>

// A moteus without physics, for tests of the rules above it. It obeys mode changes at once, stands at the commanded
// position, turns at the commanded velocity, and replies with the state before the command, as the real drive does. It
// keeps every command frame for inspection.
namespace boresight::fakes {

// The registers that one frame wrote. A list without memory of its own, because long tests keep thousands of frames.
class Written
{
public:
    void set(moteus::Register reg, double value) { m_values.at(m_count++) = {reg, value}; }
    [[nodiscard]] std::optional<double> find(moteus::Register reg) const;
    [[nodiscard]] double at(moteus::Register reg) const { return find(reg).value(); }
    [[nodiscard]] bool contains(moteus::Register reg) const { return find(reg).has_value(); }

private:
    static constexpr std::size_t kMost = 17;  // a PositionCommand

    std::array<std::pair<moteus::Register, double>, kMost> m_values;
    std::size_t m_count = 0;
};

class IdealDrive
{
public:
    IdealDrive(std::uint8_t id, double startPosition) : position(startPosition), m_id(id) {}

    struct Seen  // one command frame
    {
        moteus::Mode mode;
        Written fields;
    };

    // The reply to a frame. Empty if the frame is for another drive, or if the drive is silent.
    std::optional<CanFrame> answer(const CanFrame& frame, SteadyTime now);

    // Turns until `now` with the last command.
    void advanceTo(SteadyTime now);
    void run(double passed);  // seconds

    // Another tool sends `d exact`: the position value changes without a motion.
    void setExact(double place);

    // The origin of the position, in turns from the count since power-up.
    [[nodiscard]] MotorTurns origin() const { return MotorTurns::fromTurns(m_set); }

    moteus::Mode mode = moteus::Mode::Stopped;
    int fault = 0;
    moteus::HomeState home = moteus::HomeState::Output;
    bool silent = false;
    bool mute = false;      // obeys, but its replies are lost
    bool deaf = false;      // replies, but ignores commands
    bool modeOnly = false;  // replies with its mode only
    // reported by the next replies in place of the position; the drive itself does not move
    std::deque<double> falsePlaces;
    double position;         // output turns
    double travelled = 0.0;  // by set-points, in total
    double voltage = 24.0;
    double temperature = 31.0;
    double torque = 0.0;             // Nm
    double current = 0.0;            // A, q axis
    double dCurrent = 0.0;           // A
    double power = 0.0;              // W
    double motorTemperature = 0.0;   // 0 means no sensor
    std::optional<double> velocity;  // turns/s, reported whatever the position does; empty: not reported
    std::vector<Seen> seen;

private:
    [[nodiscard]] CanFrame stateFrame(SteadyTime now) const;
    [[nodiscard]] static Written written(const CanFrame& frame);
    void obey(const Written& fields);
    void takePlace(const Written& fields);
    [[nodiscard]] double state(moteus::Register reg) const;

    std::uint8_t m_id;
    double m_set = 0.0;
    double m_echo = moteus::kUnset;
    double m_running = 0.0;       // turns/s
    double m_ordered = 0.0;       // turns/s
    double m_acceleration = 0.0;  // turns/s²
    SteadyTime m_fed{};           // time of the last command
    SteadyTime m_now{};           // time of the last frame
};

}  // namespace boresight::fakes
