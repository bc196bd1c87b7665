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

// What a person or a script writes to the mount in plain numbers, and what is answered, bytes <-> values. Pure.
//
//   60               elevation; the azimuth stays
//   120.5 30         azimuth and elevation
//   +5 0, -5 +0, +2  by so much from where it is sent: a plus sign makes the line a move by an angle
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
    std::optional<Angle> azimuth = {};  // -3600°…3600°; empty: it stays
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

// One line without its end. InvalidInput: it is no command. OutOfRange: an angle that no mount has.
[[nodiscard]] Result<Command> parseLine(std::string_view line);
// Also where the line is no command.
[[nodiscard]] bool endsInStop(std::string_view line);
// Where the mount would go. OutOfRange: that is beyond these limits.
[[nodiscard]] Result<SkyPointing> movedBy(const SkyPointing& from, const MoveBy& move, const rotctld::Limits& limits);

inline constexpr std::string_view kDone = "OK\n";

// A target that the station has changed is done as that: "OK: 90.0° 90.0°".
[[nodiscard]] std::string doneAs(const QString& became);
// "120.5 30.0", azimuth and elevation in degrees.
[[nodiscard]] std::string reportOf(const SkyPointing& place);
// One line with the reason.
[[nodiscard]] std::string refusalOf(const Error& error);

}  // namespace boresight::pairs
