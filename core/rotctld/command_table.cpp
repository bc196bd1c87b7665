// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotctld/command_table.h"

#include <algorithm>

namespace boresight::rotctld {
namespace {

// Names, letters, argument names and labels are those of Hamlib 4.5.4, because clients read the labels. get_outcome is
// our own.
constexpr std::array kCommands{
    CommandSpec{.id = CommandId::SetPosition,
                .letter = 'P',
                .name = "set_pos",
                .arguments = {"Azimuth", "Elevation"},
                .labels = {},
                .bareName = true},
    CommandSpec{.id = CommandId::GetPosition,
                .letter = 'p',
                .name = "get_pos",
                .arguments = {},
                .labels = {"Azimuth", "Elevation"},
                .ending = Ending::Values,
                .bareName = true},
    CommandSpec{.id = CommandId::Park,
                .letter = 'K',
                .name = "park",
                .arguments = {},
                .labels = {},
                .start = Start::AfterItsWord},
    CommandSpec{.id = CommandId::Stop,
                .letter = 'S',
                .name = "stop",
                .arguments = {},
                .labels = {},
                .start = Start::UnlessGlued,
                .bareName = true},
    CommandSpec{.id = CommandId::Reset, .letter = 'R', .name = "reset", .arguments = {"Reset"}, .labels = {}},
    CommandSpec{
        .id = CommandId::Move, .letter = 'M', .name = "move", .arguments = {"Direction", "Speed"}, .labels = {}},
    CommandSpec{.id = CommandId::SetLevel,
                .letter = 'V',
                .name = "set_level",
                .arguments = {"Level", "Level Value"},
                .labels = {}},
    CommandSpec{.id = CommandId::GetLevel,
                .letter = 'v',
                .name = "get_level",
                .arguments = {"Level"},
                .labels = {},
                .ending = Ending::Values},
    CommandSpec{.id = CommandId::SetFunction,
                .letter = 'U',
                .name = "set_func",
                .arguments = {"Func", "Func Status"},
                .labels = {}},
    CommandSpec{.id = CommandId::GetFunction,
                .letter = 'u',
                .name = "get_func",
                .arguments = {"Func"},
                .labels = {},
                .ending = Ending::Values},
    CommandSpec{.id = CommandId::SetParameter,
                .letter = 'X',
                .name = "set_parm",
                .arguments = {"Parm", "Parm Value"},
                .labels = {}},
    CommandSpec{.id = CommandId::GetParameter,
                .letter = 'x',
                .name = "get_parm",
                .arguments = {"Parm"},
                .labels = {},
                .ending = Ending::Values},
    CommandSpec{.id = CommandId::SetConfiguration,
                .letter = 'C',
                .name = "set_conf",
                .arguments = {"Token", "Value"},
                .labels = {}},
    CommandSpec{.id = CommandId::GetInfo,
                .letter = '_',
                .name = "get_info",
                .arguments = {},
                .labels = {"Info"},
                .ending = Ending::Values},
    CommandSpec{.id = CommandId::GetStatus,
                .letter = 's',
                .name = "get_status",
                .arguments = {},
                .labels = {"Status flags"},
                .ending = Ending::Values},
    CommandSpec{.id = CommandId::GetOutcome,
                .letter = 0x8d,
                .name = "get_outcome",
                .arguments = {},
                .labels = {"Outcome"},
                .ending = Ending::Values},
    CommandSpec{.id = CommandId::SendRaw,
                .letter = 'w',
                .name = "send_cmd",
                .arguments = {"Cmd"},
                .labels = {},
                .restOfLine = true},
    CommandSpec{.id = CommandId::DumpCapabilities, .letter = '1', .name = "dump_caps", .arguments = {}, .labels = {}},
    CommandSpec{.id = CommandId::DumpState,
                .letter = 0x8f,
                .name = "dump_state",
                .arguments = {},
                .labels = {},
                .ending = Ending::Values},
    CommandSpec{.id = CommandId::ToLocator,
                .letter = 'L',
                .name = "lonlat2loc",
                .arguments = {"Longitude", "Latitude", "Loc Len [2-12]"},
                .labels = {"Locator"},
                .ending = Ending::Values},
    CommandSpec{.id = CommandId::FromLocator,
                .letter = 'l',
                .name = "loc2lonlat",
                .arguments = {"Locator"},
                .labels = {"Longitude", "Latitude"},
                .ending = Ending::Values},
    CommandSpec{.id = CommandId::DmsToDegrees,
                .letter = 'D',
                .name = "dms2dec",
                .arguments = {"Degrees", "Minutes", "Seconds", "S/W"},
                .labels = {"Dec Degrees"},
                .ending = Ending::Values},
    CommandSpec{.id = CommandId::DegreesToDms,
                .letter = 'd',
                .name = "dec2dms",
                .arguments = {"Dec Degrees"},
                .labels = {"Degrees", "Minutes", "Seconds", "S/W"},
                .ending = Ending::Values},
    CommandSpec{.id = CommandId::MinutesToDegrees,
                .letter = 'E',
                .name = "dmmm2dec",
                .arguments = {"Degrees", "Dec Minutes", "S/W"},
                .labels = {"Dec Deg"},
                .ending = Ending::Values},
    CommandSpec{.id = CommandId::DegreesToMinutes,
                .letter = 'e',
                .name = "dec2dmmm",
                .arguments = {"Dec Deg"},
                .labels = {"Degrees", "Dec Minutes", "S/W"},
                .ending = Ending::Values},
    CommandSpec{.id = CommandId::GreatCircle,
                .letter = 'B',
                .name = "qrb",
                .arguments = {"Lon 1", "Lat 1", "Lon 2", "Lat 2"},
                .labels = {"QRB Distance", "QRB Azimuth"},
                .ending = Ending::Values},
    CommandSpec{.id = CommandId::LongPathAzimuth,
                .letter = 'A',
                .name = "a_sp2a_lp",
                .arguments = {"Short Path Deg"},
                .labels = {"Long Path Deg"},
                .ending = Ending::Values},
    CommandSpec{.id = CommandId::LongPathDistance,
                .letter = 'a',
                .name = "d_sp2d_lp",
                .arguments = {"Short Path km"},
                .labels = {"Long Path km"},
                .ending = Ending::Values},
    CommandSpec{.id = CommandId::Pause, .letter = 0x8c, .name = "pause", .arguments = {"Seconds"}, .labels = {}},
    CommandSpec{
        .id = CommandId::Help, .letter = '?', .name = {}, .arguments = {}, .labels = {}, .ending = Ending::Silent},
    CommandSpec{
        .id = CommandId::Quit, .letter = 'q', .name = {}, .arguments = {}, .labels = {}, .ending = Ending::Silent},
    CommandSpec{
        .id = CommandId::Quit, .letter = 'Q', .name = {}, .arguments = {}, .labels = {}, .ending = Ending::Silent},
};

constexpr std::array<const CommandSpec*, 256> letterIndex()
{
    std::array<const CommandSpec*, 256> index{};
    for (const CommandSpec& spec : kCommands) {
        index[spec.letter] = &spec;
    }
    return index;
}

constexpr auto kByLetter = letterIndex();

std::string helpLine(const CommandSpec& spec)
{
    std::string line(1, spec.letter < 0x80 ? static_cast<char>(spec.letter) : '-');
    line.append(": ").append(spec.name);
    line.resize(std::max(line.size(), std::size_t{15}), ' ');
    line += '(';
    for (std::size_t i = 0; i < spec.argumentCount(); ++i) {
        line.append(i == 0 ? "" : ", ").append(spec.arguments[i]);
    }
    return line + ")\n";
}

}  // namespace

std::size_t CommandSpec::argumentCount() const
{
    return static_cast<std::size_t>(std::ranges::count_if(arguments, [](auto argument) { return !argument.empty(); }));
}

std::span<const CommandSpec> commandTable()
{
    return kCommands;
}

const CommandSpec* findCommand(unsigned char letter)
{
    return kByLetter[letter];
}

const CommandSpec* findCommand(std::string_view name)
{
    if (name.empty()) {
        return nullptr;
    }
    const auto found = std::ranges::find(kCommands, name, &CommandSpec::name);
    return found == kCommands.end() ? nullptr : &*found;
}

const std::string& helpText()
{
    static const std::string text = [] {
        std::string lines = "Commands (long names after a backslash, q closes the connection):\n";
        for (const CommandSpec& spec : kCommands) {
            if (!spec.name.empty()) {
                lines += helpLine(spec);
            }
        }
        return lines;
    }();
    return text;
}

}  // namespace boresight::rotctld
