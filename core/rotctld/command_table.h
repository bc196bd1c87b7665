// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

// Every command of the rotctld protocol, described once: the parser, the replies and the help text follow this table.
// Constant data, any thread.
namespace boresight::rotctld {

enum class CommandId : std::uint8_t
{
    SetPosition,
    GetPosition,
    Park,
    Stop,
    Reset,
    Move,
    SetLevel,
    GetLevel,
    SetFunction,
    GetFunction,
    SetParameter,
    GetParameter,
    SetConfiguration,
    GetInfo,
    GetStatus,
    SendRaw,
    DumpCapabilities,
    DumpState,
    ToLocator,
    FromLocator,
    DmsToDegrees,
    DegreesToDms,
    MinutesToDegrees,
    DegreesToMinutes,
    GreatCircle,
    LongPathAzimuth,
    LongPathDistance,
    Pause,
    Help,
    Quit
};

// How a successful default reply ends: with RPRT 0, with its values only, or with nothing at all.
enum class Ending : std::uint8_t
{
    Code,
    Values,
    Silent
};

// When a command without arguments runs. Hamlib runs every one at its letter; a browser's "(KHTML" then parks the
// antenna and "STATS" stops it. Reading may run at once, acting wants to see that the word ends.
enum class Start : std::uint8_t
{
    AtOnce,        // "pp" are two
    UnlessGlued,   // not when anything but a blank or line end has come right behind it; a lone letter runs at once
    AfterItsWord,  // only when a blank, a line end or the end of input has come
};

inline constexpr std::size_t kMaxArguments = 4;

struct CommandSpec
{
    CommandId id;
    unsigned char letter;   // the one-byte form; above 0x7f Hamlib's internal code of a long-only command
    std::string_view name;  // the long form, after a backslash
    std::array<std::string_view, kMaxArguments> arguments;
    std::array<std::string_view, kMaxArguments> labels;  // of the values in extended replies
    Ending ending = Ending::Code;
    Start start = Start::AtOnce;
    bool bareName = false;    // the name opening a line is also understood without backslash
    bool restOfLine = false;  // the only argument is the rest of the line

    [[nodiscard]] std::size_t argumentCount() const;
};

[[nodiscard]] std::span<const CommandSpec> commandTable();
[[nodiscard]] const CommandSpec* findCommand(unsigned char letter);
[[nodiscard]] const CommandSpec* findCommand(std::string_view name);

// The answer to `??`.
[[nodiscard]] const std::string& helpText();

}  // namespace boresight::rotctld
