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

// What a program sends to a GS-232 box and what the box answers, bytes <-> values. The other direction is core/gs232.
// Pure.
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
    std::optional<Angle> elevation;  // 0…180°; empty: as it is
};

struct Turn  // until a stop
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

// One line without its end, in upper or lower case. InvalidInput: it is no command. OutOfRange: an angle that the
// protocol does not know. NotAvailable: a command of the real box that an emulation must not obey: lists with times,
// calibration, the way it counts.
[[nodiscard]] Result<ClientCommand> parseCommand(std::string_view line);

inline constexpr std::string_view kRefusal = "?>\r\n";
inline constexpr std::string_view kAccepted = "\r";

// In whole degrees of three digits. OutOfRange: the protocol has no number for this place.
[[nodiscard]] Result<std::string> answerTo(Ask question, const SkyPointing& place, Dialect dialect);

}  // namespace boresight::gs232
