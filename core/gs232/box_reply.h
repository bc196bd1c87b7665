// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/quantity.h"

#include <optional>
#include <string_view>
#include <variant>

// Reads one line of a GS-232 box, without its end. Both dialects are read: "+0180+0090" of the A and "AZ=180  EL=090"
// of the B, with the variations of imitations. A line that is not completely one of them is Unknown: half a number is
// never a number. Pure.
namespace boresight::gs232 {

enum class Dialect
{
    A,
    B
};

struct Position
{
    Dialect dialect = Dialect::A;
    std::optional<Angle> azimuth;  // in the count of the box: 370° is not 10°
    std::optional<Angle> elevation;

    bool operator==(const Position&) const = default;
};

struct Refused  // "?>"
{
    bool operator==(const Refused&) const = default;
};

struct Nothing  // an acknowledgement or a prompt without text
{
    bool operator==(const Nothing&) const = default;
};

struct Echo  // of our own command
{
    bool operator==(const Echo&) const = default;
};

struct Unknown  // damaged, or of another kind of device
{
    bool operator==(const Unknown&) const = default;
};

using Reply = std::variant<Position, Refused, Nothing, Echo, Unknown>;

[[nodiscard]] Reply parseReply(std::string_view line);

}  // namespace boresight::gs232
