// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/rotctld/rotator.h"

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

// What a program sends to an EasyComm controller and what the controller answers, bytes <-> values. A line has commands
// of two letters with a value, divided by blanks: "AZ123.4 EL45.6". Pure.
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

struct Target  // one of the two at least; what is empty stays
{
    std::optional<Angle> azimuth;    // -3600°…3600°
    std::optional<Angle> elevation;  // -90°…180°
};

struct Turn  // until a stop
{
    rotctld::MoveDirection direction = rotctld::MoveDirection::Up;
    std::optional<AngularRate> rate = {};  // empty: the program sets none. Zero ends the turning
};

struct StopTurning  // of either axis or both
{};

struct Park
{};

struct Reset
{};

struct NotForARotator  // for the radio, the clock, the outputs of a controller
{};

using Command = std::variant<Ask, Target, Turn, StopTurning, Park, Reset, NotForARotator>;

// One of its words is a stop.
[[nodiscard]] bool hasStop(std::string_view line);
// The commands of one line without its end, in upper or lower case. A line is obeyed wholly or not at all.
// InvalidInput: a word is no command of this version, or the line asks for two motions. OutOfRange: an angle that no
// mount has. NotAvailable: registers and inputs of a real controller.
[[nodiscard]] Result<std::vector<Command>> parseLine(std::string_view line, Version version);

// In tenths of a degree.
[[nodiscard]] std::string azimuthAnswer(Angle azimuth);
[[nodiscard]] std::string elevationAnswer(Angle elevation);
// An alarm, as a controller sends it: what was refused, in the words of the protocol.
[[nodiscard]] std::string alarmOf(const Error& error);

inline constexpr std::string_view kIdle = "GS1";
inline constexpr std::string_view kMoving = "GS2";
inline constexpr std::string_view kInError = "GS8";
inline constexpr std::string_view kNoErrors = "GE0";
inline constexpr std::string_view kSensorError = "GE1";
inline constexpr std::string_view kLineEnd = "\n";

}  // namespace boresight::easycomm
