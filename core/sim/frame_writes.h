// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/moteus/subframes.h"
#include "core/sim/servo_control.h"

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

// What one frame writes to the registers of a simulated drive, until its end. What an accepted frame left in command
// registers is there for the next one. Pure.
namespace boresight::sim {

class FrameWrites
{
public:
    void begin();
    // 0, or the error code for the reply.
    [[nodiscard]] std::uint32_t write(moteus::Register reg, double value);
    void accept() { m_accepted = m_kept; }
    // Nothing was ever accepted, from the next frame on.
    void forget() { m_accepted = {}; }

    [[nodiscard]] const ServoCommand& command() const { return m_kept.command; }
    [[nodiscard]] bool hasMode() const { return m_hasMode; }
    // Registers that do something at once, in the order of writing.
    [[nodiscard]] const std::vector<moteus::RegisterValue>& actions() const { return m_actions; }
    // Of a register that can be written and read and does nothing here.
    [[nodiscard]] std::optional<double> unused(moteus::Register reg) const;

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
