// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

// Every command of the rotctld protocol, described once. The parser, the replies and the help text use this table.
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
    GetOutcome,  // of Boresight, not of Hamlib (HAMLIB.md)
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

// How a successful reply in the default form ends: with RPRT 0, with its values only, or with nothing.
enum class Ending : std::uint8_t
{
    Code,
    Values,
    Silent
};

// When a command without arguments runs. Hamlib runs every command at its letter. So "(KHTML" of a browser parks the
// antenna, and "STATS" stops it. Here a command that only reads may run at once, and a command that acts waits for the
// end of its word.
enum class Start : std::uint8_t
{
    AtOnce,  // "pp" are two commands
    // Not if a character other than a blank or line end has arrived directly after it. If nothing has arrived yet, it
    // runs at once, except after an unknown command.
    UnlessGlued,
    AfterItsWord,  // only after a blank, a line end or the end of input
};

inline constexpr std::size_t kMaxArguments = 4;

struct CommandSpec
{
    CommandId id;
    unsigned char letter;   // the one-byte form; above 0x7f: Hamlib's internal code of a command with only a long form
    std::string_view name;  // the long form, after a backslash
    std::array<std::string_view, kMaxArguments> arguments;
    std::array<std::string_view, kMaxArguments> labels;  // labels of the values in extended replies
    Ending ending = Ending::Code;
    Start start = Start::AtOnce;
    bool bareName = false;    // the name at the start of a line is also accepted without backslash
    bool restOfLine = false;  // the only argument is the rest of the line

    [[nodiscard]] std::size_t argumentCount() const;
};

[[nodiscard]] std::span<const CommandSpec> commandTable();
[[nodiscard]] const CommandSpec* findCommand(unsigned char letter);
[[nodiscard]] const CommandSpec* findCommand(std::string_view name);

// The answer to `??`.
[[nodiscard]] const std::string& helpText();

}  // namespace boresight::rotctld
