// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/rotctld/rotator.h"
#include "core/targets/target.h"
#include "core/units/sky.h"

#include <optional>
#include <string>
#include <string_view>
#include <variant>

// The lines of a person or a script in plain numbers, and the answers, bytes <-> values. Pure.
//
//   60               elevation; the azimuth stays
//   120.5 30         azimuth and elevation
//   +5 0, -5 +0, +2  move by these angles from the target: a plus sign makes the line a move
//   bearing IM58kr, bearing IM58kr long
//   stop, hold, park, ?
namespace boresight::pairs {

struct Report
{};

struct Stop
{};

struct Park
{};

struct Place
{
    std::optional<Angle> azimuth = {};  // -3600°…3600°; empty: stays as it is
    Angle elevation;                    // -90°…180°
};

struct MoveBy
{
    Angle azimuth;
    Angle elevation;
};

struct Bearing
{
    targets::Target target;
};

using Command = std::variant<Report, Stop, Park, Place, MoveBy, Bearing>;

// Reads one line without its end. InvalidInput: not a command. OutOfRange: an angle that no mount has.
[[nodiscard]] Result<Command> parseLine(std::string_view line);
// True if the last word is a stop, even if the line is no command.
[[nodiscard]] bool endsInStop(std::string_view line);
// True if the line is a hold.
[[nodiscard]] bool isHold(std::string_view line);
// The target of the move. OutOfRange: it is beyond these limits.
[[nodiscard]] Result<SkyPointing> movedBy(const SkyPointing& from, const MoveBy& move, const rotctld::Limits& limits);

inline constexpr std::string_view kDone = "OK\n";

// The answer if the station has changed the target: "OK: 90.0° 90.0°".
[[nodiscard]] std::string doneAs(const QString& became);
// "120.5 30.0", azimuth and elevation in degrees.
[[nodiscard]] std::string reportOf(const SkyPointing& place);
// One line with the reason.
[[nodiscard]] std::string refusalOf(const Error& error);

}  // namespace boresight::pairs
