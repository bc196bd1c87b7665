// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/sim/console_device.h"

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>

// The text console of a moteus behind its diagnostic tunnel. Answers `conf`, `tel` and `d` commands, one per line, like
// the device. Pure. The device behind the console is a ConsoleDevice. `conf` and `d` are in console_commands.h.
namespace boresight::sim {

class DiagnosticConsole
{
public:
    explicit DiagnosticConsole(ConsoleDevice& device) : m_device(device) {}

    void receive(std::span<const std::uint8_t> text);
    void advance(double dt);  // periodic telemetry
    void reset();

    [[nodiscard]] std::span<const std::uint8_t> pending() const;
    void drop(std::size_t count);

private:
    struct Channel
    {
        bool text = false;
        double period = 0.0;  // s; 0: not sent
        double elapsed = 0.0;
    };

    void execute(std::string_view line);
    [[nodiscard]] std::string tel(std::string_view command, std::string_view rest);
    [[nodiscard]] std::string telFormat(std::string_view command, std::string_view rest);
    [[nodiscard]] std::string report(const std::string& name);

    ConsoleDevice& m_device;
    std::string m_input;
    std::string m_output;
    std::map<std::string, Channel, std::less<>> m_channels;  // only the channels that were set up
};

}  // namespace boresight::sim
