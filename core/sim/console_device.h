// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/sim/console_record.h"
#include "core/sim/drive_config.h"
#include "core/sim/servo_control.h"

#include <string>
#include <string_view>
#include <vector>

// The functions of a drive that its console needs.
namespace boresight::sim {

class ConsoleDevice
{
public:
    virtual ~ConsoleDevice() = default;

    virtual DriveConfig& config() = 0;
    // Called after a key of that group was set, or after all keys of the group were loaded.
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
    // Empty if the channel does not exist.
    [[nodiscard]] virtual std::vector<ArchiveField> telemetry(std::string_view channel) = 0;

protected:
    ConsoleDevice() = default;
    ConsoleDevice(const ConsoleDevice&) = default;
    ConsoleDevice& operator=(const ConsoleDevice&) = default;
};

}  // namespace boresight::sim
