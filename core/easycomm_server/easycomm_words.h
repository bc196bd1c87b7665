// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/rotctld/rotator.h"

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

// The commands of a program to an EasyComm controller and the answers of the controller, bytes <-> values. A line has
// commands of two letters with a value, separated by blanks: "AZ123.4 EL45.6". Pure.
namespace boresight::easycomm {

enum class Version
{
    One,   // points and stops
    Two,   // reports, turns, parks
    Three  // turns at a rate, reports its state
};

enum class Ask
{
    Azimuth,
    Elevation,
    Version,
    Status,
    Errors
};

struct Target  // at least one of the two; an empty one stays as it is
{
    std::optional<Angle> azimuth;    // -3600°…3600°
    std::optional<Angle> elevation;  // -90°…180°
};

struct Turn  // until a stop command
{
    rotctld::MoveDirection direction = rotctld::MoveDirection::Up;
    std::optional<AngularRate> rate = {};  // empty: the program sets no rate. Zero ends the turning
};

struct StopTurning  // of either axis or both
{};

struct Park
{};

struct Reset
{};

struct NotForARotator  // for the radio, the clock or the outputs of a controller
{};

using Command = std::variant<Ask, Target, Turn, StopTurning, Park, Reset, NotForARotator>;

// True if one of the words is a stop.
[[nodiscard]] bool hasStop(std::string_view line);
// Reads the commands of one line without its end, in upper or lower case. A line is carried out completely or not at
// all. InvalidInput: a word is no command of this version, or the line asks for two motions. OutOfRange: an angle that
// no mount has. NotAvailable: registers and inputs of a real controller.
[[nodiscard]] Result<std::vector<Command>> parseLine(std::string_view line, Version version);

// In tenths of a degree.
[[nodiscard]] std::string azimuthAnswer(Angle azimuth);
[[nodiscard]] std::string elevationAnswer(Angle elevation);
// The alarm of a controller: the reason of the refusal in a word of the protocol.
[[nodiscard]] std::string alarmOf(const Error& error);

inline constexpr std::string_view kIdle = "GS1";
inline constexpr std::string_view kMoving = "GS2";
inline constexpr std::string_view kInError = "GS8";
inline constexpr std::string_view kNoErrors = "GE0";
inline constexpr std::string_view kSensorError = "GE1";
inline constexpr std::string_view kLineEnd = "\n";

}  // namespace boresight::easycomm
