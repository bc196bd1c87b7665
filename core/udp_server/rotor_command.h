// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/units/sky.h"

#include <QString>

#include <functional>
#include <optional>
#include <string_view>
#include <variant>

// The command in a datagram for a rotator, in whatever protocol. Pure.
namespace boresight::udp {

enum class Ask
{
    Azimuth,
    Elevation,
    TargetAzimuth
};

struct Target  // at least one of the two; an axis without an angle stays
{
    std::optional<Angle> azimuth;    // -3600°…3600°
    std::optional<Angle> elevation;  // -90°…180°
};

struct StopTurning  // both axes
{};

struct Park
{};

struct Nothing
{
    QString why;  // for the list of clients: for another rotor, or it asks for what is already so
};

using Command = std::variant<Ask, Target, StopTurning, Park, Nothing>;

using Parse = std::function<Result<Command>(std::string_view datagram)>;

[[nodiscard]] inline bool stops(const Result<Command>& command)
{
    return command && std::holds_alternative<StopTurning>(*command);
}

[[nodiscard]] inline bool moves(const Command& command)
{
    return std::holds_alternative<Target>(command) || std::holds_alternative<Park>(command);
}

}  // namespace boresight::udp
