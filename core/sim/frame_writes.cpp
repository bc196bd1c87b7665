// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim/frame_writes.h"

#include "core/sim/command_registers.h"

namespace boresight::sim {
namespace {

using moteus::Mode;
using moteus::Register;

constexpr std::uint32_t kUnknown = 1;  // error code: this value or register does not exist

}  // namespace

void FrameWrites::begin()
{
    m_kept = m_accepted;
    m_hasMode = false;
    m_actions.clear();
}

std::uint32_t FrameWrites::write(Register reg, double value)
{
    if (reg == Register::Mode) {
        if (!(value >= 0.0 && value < moteus::kModeCount)) {
            return kUnknown;
        }
        m_kept.command = {.mode = static_cast<Mode>(static_cast<int>(value))};
        m_hasMode = true;
        return 0;
    }
    if (writeCommand(m_kept.command, reg, value)) {
        return 0;
    }
    if (reg >= Register::SetOutputNearest && reg <= Register::RecapturePositionVelocity) {
        m_actions.push_back({.reg = reg, .value = value});
        return 0;
    }
    m_kept.unused[reg] = value;
    return 0;
}

std::optional<double> FrameWrites::unused(Register reg) const
{
    const auto found = m_kept.unused.find(reg);
    return found != m_kept.unused.end() ? std::optional(found->second) : std::nullopt;
}

std::optional<double> FrameWrites::accepted(Register reg) const
{
    const auto found = m_accepted.unused.find(reg);
    return found != m_accepted.unused.end() ? std::optional(found->second) : std::nullopt;
}

}  // namespace boresight::sim
