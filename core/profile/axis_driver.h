// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtGlobal>

#include <array>
#include <cstddef>
#include <string_view>

// The only list of drivers, which turn the axes. The choices of the profile, the checks and --simulate=NAME come from
// it. A new kind of rotator needs its name and its line here. A line in core/station/mount_factory.cpp creates it.
namespace boresight::profile {

enum class AxisDriver
{
    Moteus,
    Gs232,
    Rotctld,
    Simple,
    None
};

// The connection to a driver.
enum class DriverLine
{
    None,
    Can,
    Text,    // a serial port or a TCP connection that carries lines of text
    Rotctld  // a rotctld on the network, or one that Boresight starts
};

struct DriverKind
{
    AxisDriver driver;
    std::string_view name;       // in the profile
    std::string_view title;      // for people, in English
    std::string_view simulated;  // description of the simulated driver, in English
    DriverLine line = DriverLine::None;
    bool onlySimulated = false;
    bool hasId = false;         // each axis has a controller of its own, with an id on the bus
    bool sensorInside = false;  // two simulated axes carry a simulated orientation sensor
    bool countsItself = false;  // the angles of the axis are those of its box: a sign or an offset has no effect
};

// In the order of the enumerators.
inline constexpr std::array kDriverKinds{
    DriverKind{.driver = AxisDriver::Moteus,
               .name = "moteus",
               .title = QT_TRANSLATE_NOOP("Text", "moteus"),
               .simulated = "a moteus drive",
               .line = DriverLine::Can,
               .hasId = true,
               .sensorInside = true},
    DriverKind{.driver = AxisDriver::Gs232,
               .name = "gs232",
               .title = QT_TRANSLATE_NOOP("Text", "GS-232"),
               .simulated = "a GS-232 box with relays, whole degrees and a coast",
               .line = DriverLine::Text,
               .countsItself = true},
    DriverKind{.driver = AxisDriver::Rotctld,
               .name = "rotctld",
               .title = QT_TRANSLATE_NOOP("Text", "Hamlib (rotctld)"),
               .simulated = "a rotctld with the dummy rotator of Hamlib",
               .line = DriverLine::Rotctld,
               .countsItself = true},
    DriverKind{.driver = AxisDriver::Simple,
               .name = "simple",
               .title = QT_TRANSLATE_NOOP("Text", "Simple (simulated)"),
               .simulated = "a rotator of whole degrees, without rates and watchdog",
               .onlySimulated = true},
    DriverKind{.driver = AxisDriver::None,
               .name = "none",
               .title = QT_TRANSLATE_NOOP("Text", "No such axis"),
               .simulated = {}},
};

[[nodiscard]] constexpr const DriverKind& kindOf(AxisDriver driver)
{
    return kDriverKinds[static_cast<std::size_t>(driver)];
}

// Devices that --simulate=NAME offers in place of the usual one of their driver.
enum class SimulatedDevice
{
    Usual,
    Esp32
};

struct OtherDevice
{
    SimulatedDevice device;
    AxisDriver driver;
    std::string_view name;
    std::string_view simulated;  // description, in English
};

inline constexpr std::array kOtherDevices{
    OtherDevice{.device = SimulatedDevice::Esp32,
                .driver = AxisDriver::Gs232,
                .name = "esp32",
                .simulated = "an ESP32 relay controller, whose stops do not stop it"},
};

// The text of the setting for people. It explains the drivers whose names are not clear by themselves.
inline constexpr const char* kDriverMeaning =
    QT_TRANSLATE_NOOP("Text",
                      "What turns the axis. Each axis may have its own driver. \"gs232\" is a Yaesu GS-232A, a GS-232B "
                      "or a compatible box. \"rotctld\" is any rotator that Hamlib drives. \"simple\" is simulated "
                      "only: a rotator of whole degrees without a watchdog. With \"none\" the mount has no such axis.");

}  // namespace boresight::profile
