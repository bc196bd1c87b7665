// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/sim/archive.h"
#include "core/sim/drive_config.h"
#include "core/sim/servo.h"

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

// The text console of a moteus behind its diagnostic tunnel: `conf`, `tel` and `d` commands, one per line, answered as
// the device answers them. Pure; the device behind it is a ConsoleDevice.
namespace boresight::sim {

class ConsoleDevice
{
public:
    virtual ~ConsoleDevice() = default;

    virtual DriveConfig& config() = 0;
    // After a key of that group was set, or all of them loaded.
    virtual void configChanged(std::string_view group) = 0;
    virtual void storeConfig() = 0;
    virtual void loadConfig() = 0;
    virtual void defaultConfig() = 0;

    virtual void consoleCommand(const ServoCommand& command) = 0;
    virtual void setOutputExact(double position) = 0;
    virtual void setOutputNearest(double position) = 0;
    virtual void configureOutput(double position) = 0;
    virtual void requireReindex() = 0;
    virtual void recapture() = 0;

    [[nodiscard]] virtual std::vector<std::string> telemetryChannels() const = 0;
    // Empty for a channel that does not exist.
    [[nodiscard]] virtual std::vector<ArchiveField> telemetry(std::string_view channel) = 0;

protected:
    ConsoleDevice() = default;
    ConsoleDevice(const ConsoleDevice&) = default;
    ConsoleDevice& operator=(const ConsoleDevice&) = default;
};

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
        double period = 0.0;  // s, 0: not emitted
        double elapsed = 0.0;
    };

    void execute(std::string_view line);
    [[nodiscard]] std::string conf(std::string_view command, std::string_view rest);
    [[nodiscard]] std::string confSet(std::string_view rest);
    [[nodiscard]] std::string confEnumerate(std::string_view group);
    [[nodiscard]] std::string confBinary(std::string_view command, std::string_view group);
    [[nodiscard]] std::string tel(std::string_view command, std::string_view rest);
    [[nodiscard]] std::string telFormat(std::string_view command, std::string_view rest);
    [[nodiscard]] std::string emit(const std::string& name);
    [[nodiscard]] std::string drive(std::string_view command, std::string_view rest);
    [[nodiscard]] std::string driveMove(std::string_view command, std::string_view rest);
    [[nodiscard]] std::string driveOutput(std::string_view command, std::string_view rest);

    ConsoleDevice& m_device;
    std::string m_input;
    std::string m_output;
    std::map<std::string, Channel, std::less<>> m_channels;  // only those that were set up
};

}  // namespace boresight::sim
