// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/moteus/frame_server.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

// A served device that holds the values that the test sets and keeps what was written. Registers without a value read
// 0.
namespace boresight::moteus {

class RecordingDevice final : public ServedDevice
{
public:
    std::map<Register, double> registers;
    std::vector<std::pair<Register, double>> writes;
    std::vector<FrameEnd> ends;
    std::string text;      // waiting on channel 1
    std::string received;  // on channel 1

    [[nodiscard]] double readRegister(Register reg) override
    {
        const auto found = registers.find(reg);
        return found == registers.end() ? 0.0 : found->second;
    }
    [[nodiscard]] std::uint32_t writeRegister(Register reg, double value) override
    {
        if (reg == Register::Mode && (value < 0 || value >= kModeCount)) {
            return kUnknownRegister;
        }
        writes.emplace_back(reg, value);
        return 0;
    }
    void completeFrame(FrameEnd end) override { ends.push_back(end); }
    [[nodiscard]] bool hasChannel(std::uint32_t channel) override { return channel == 1; }
    void receiveText(std::uint32_t, std::span<const std::uint8_t> bytes) override
    {
        received.append(bytes.begin(), bytes.end());
    }
    [[nodiscard]] std::span<const std::uint8_t> pendingText(std::uint32_t) override
    {
        m_pending.assign(text.begin(), text.end());
        return m_pending;
    }
    void dropText(std::uint32_t, std::size_t count) override { text.erase(0, std::min(count, text.size())); }

private:
    std::vector<std::uint8_t> m_pending;
};

}  // namespace boresight::moteus
