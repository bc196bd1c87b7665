// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/moteus/subframes.h"
#include "core/sim/servo_control.h"

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

// The writes of one frame to the registers of a simulated drive, until the end of the frame. An accepted frame leaves
// its values in the command registers for the next frame. Pure.
namespace boresight::sim {

class FrameWrites
{
public:
    void begin();
    // 0 on success, or the error code for the reply.
    [[nodiscard]] std::uint32_t write(moteus::Register reg, double value);
    void accept() { m_accepted = m_kept; }
    // From the next frame on, as if no frame was accepted yet.
    void forget() { m_accepted = {}; }

    [[nodiscard]] const ServoCommand& command() const { return m_kept.command; }
    [[nodiscard]] bool hasMode() const { return m_hasMode; }
    // The registers that act at once, in the order of writing.
    [[nodiscard]] const std::vector<moteus::RegisterValue>& actions() const { return m_actions; }
    // The value of a register that can be written and read but has no effect in the simulator.
    [[nodiscard]] std::optional<double> unused(moteus::Register reg) const;
    // The same, by the frames that were accepted.
    [[nodiscard]] std::optional<double> accepted(moteus::Register reg) const;

private:
    struct Kept
    {
        ServoCommand command;
        std::map<moteus::Register, double> unused;
    };

    Kept m_kept;
    Kept m_accepted;
    bool m_hasMode = false;
    std::vector<moteus::RegisterValue> m_actions;
};

}  // namespace boresight::sim
