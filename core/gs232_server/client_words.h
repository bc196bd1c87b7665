// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/gs232/box_reply.h"
#include "core/rotctld/rotator.h"
#include "core/units/sky.h"

#include <optional>
#include <string>
#include <string_view>
#include <variant>

// The commands of a program to a GS-232 box and the answers of the box, bytes <-> values. The other direction is
// core/gs232. Pure.
namespace boresight::gs232 {

enum class Ask
{
    Azimuth,
    Elevation,
    Both
};

struct PointTo
{
    Angle azimuth;                   // 0…450°
    std::optional<Angle> elevation;  // 0…180°; empty: stays as it is
};

struct Turn  // until a stop command
{
    rotctld::MoveDirection direction = rotctld::MoveDirection::Up;
};

struct StopTurning  // of either axis or both
{};

struct Speed
{
    int level = 1;  // 1…4
};

using ClientCommand = std::variant<Ask, PointTo, Turn, StopTurning, Speed>;

// Reads one line without its end, in upper or lower case. InvalidInput: not a command. OutOfRange: an angle outside the
// protocol. NotAvailable: a command of the real box that an emulation must not carry out: lists with times,
// calibration, settings of its count.
[[nodiscard]] Result<ClientCommand> parseCommand(std::string_view line);

inline constexpr std::string_view kRefusal = "?>\r\n";
inline constexpr std::string_view kAccepted = "\r";

// In whole degrees of three digits. OutOfRange: the protocol has no number for this position.
[[nodiscard]] Result<std::string> answerTo(Ask question, const SkyPointing& place, Dialect dialect);

}  // namespace boresight::gs232
