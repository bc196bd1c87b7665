// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/quantity.h"

#include <array>
#include <optional>
#include <string_view>
#include <variant>

// Reads one line of the ESP32 relay controller, without its end. Only a complete line has a meaning: half a number is
// never a number. Pure.
namespace boresight::gs232::esp32 {

struct Place
{
    Angle azimuth;  // a heading: the box folds it into 0…360°
    Angle elevation;

    bool operator==(const Place&) const = default;
};

struct Code  // "RPRT 0": the command was accepted
{
    bool accepted = false;

    bool operator==(const Code&) const = default;
};

struct Version  // the answer that proves such a box
{
    bool operator==(const Version&) const = default;
};

struct Started  // the greeting after power-up
{
    bool operator==(const Started&) const = default;
};

struct Debugs  // its reports are switched on or off
{
    bool on = false;

    bool operator==(const Debugs&) const = default;
};

// How well the sensor of the box is calibrated, from 0 (not) to 3 (fully).
struct Digits
{
    int system = 0;
    int gyroscope = 0;
    int accelerometer = 0;
    int magnetometer = 0;
    bool blocks = false;  // the box calibrates, and answers nothing until all digits are 3

    bool operator==(const Digits&) const = default;
};

struct Unread  // damaged, text for people, or of another kind of device
{
    bool operator==(const Unread&) const = default;
};

using Reply = std::variant<Place, Code, Version, Started, Debugs, Digits, Unread>;

[[nodiscard]] Reply parseLine(std::string_view line);
// No GS-232 box sends such a line.
[[nodiscard]] bool isLineOfEsp32(std::string_view line);

}  // namespace boresight::gs232::esp32
