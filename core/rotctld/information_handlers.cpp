// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/numbers.h"
#include "core/rotctld/handlers.h"

#include <algorithm>
#include <array>

namespace boresight::rotctld {
namespace {

// The model number of the dummy rotator of Hamlib. Clients only show it, and some know no other number.
constexpr std::string_view kModel = "1";

std::string oneLine(std::string text)
{
    std::ranges::replace_if(
        text, [](char byte) { return byte == '\n' || byte == '\r'; }, ' ');
    return text.empty() ? "None" : text;
}

std::string flagWords(const MotionFlags& flags)
{
    const bool azimuth = flags.movingLeft || flags.movingRight;
    const bool elevation = flags.movingUp || flags.movingDown;
    struct Word
    {
        bool shown;
        std::string_view text;
    };
    const std::array words{
        Word{azimuth || elevation, "MOVING"},  Word{azimuth, "MOVING_AZ"},
        Word{flags.movingLeft, "MOVING_LEFT"}, Word{flags.movingRight, "MOVING_RIGHT"},
        Word{elevation, "MOVING_EL"},          Word{flags.movingUp, "MOVING_UP"},
        Word{flags.movingDown, "MOVING_DOWN"}, Word{flags.limitUp, "LIMIT_UP"},
        Word{flags.limitDown, "LIMIT_DOWN"},   Word{flags.limitLeft, "LIMIT_LEFT"},
        Word{flags.limitRight, "LIMIT_RIGHT"},
    };
    std::string text;
    for (const Word& word : words) {
        if (word.shown) {
            text.append(word.text).append(" ");
        }
    }
    return text;
}

struct NamedLimit
{
    std::string_view tag;
    std::string_view label;
    Angle value;
};

std::array<NamedLimit, 4> named(const Limits& limits)
{
    return {{{"min_az", "Minimum Azimuth", limits.minAzimuth},
             {"max_az", "Maximum Azimuth", limits.maxAzimuth},
             {"min_el", "Minimum Elevation", limits.minElevation},
             {"max_el", "Maximum Elevation", limits.maxElevation}}};
}

// Six decimals, like %f in C. Lines stay far below the 64 bytes that a Hamlib client can read.
void dumpState(const Command& command, const Context& context, ReplyWriter& reply)
{
    const auto limits = named(context.rotator.limits());
    const auto entry = [&](std::string_view tag, std::string_view label, std::string_view value) {
        reply.line(std::string(command.extended ? label : tag).append(value));
    };
    entry("", "rotctld Protocol Ver: ", "1");
    entry("", "Rotor Model: ", kModel);
    if (!command.extended && context.dumpState == DumpStateForm::OldAndNew) {
        for (const NamedLimit& limit : limits) {
            reply.line(formatFixed(limit.value.degrees(), 6));
        }
    }
    for (const NamedLimit& limit : limits) {
        entry(std::string(limit.tag) + "=", std::string(limit.label) + ": ", formatFixed(limit.value.degrees(), 6));
    }
    entry("south_zero=", "South Zero: ", "0");
    reply.line("rot_type=AzEl");
    reply.line("done");
}

// Clients search this text for lines by their names. With header and code it must stay under 2000 bytes (HamClock).
void dumpCapabilities(const Context& context, ReplyWriter& reply)
{
    const Limits limits = context.rotator.limits();
    const auto degrees = [](Angle angle) { return formatFixed(angle.degrees(), 2) + "\n"; };
    std::string text = "Caps dump for model:\t" + std::string(kModel) + "\n";
    text +=
        "Model name:\t\tBoresight\n"
        "Mfg name:\t\tBoresight\n"
        "Backend status:\t\tStable\n"
        "Rot type:\t\tAz-El\n"
        "Port type:\t\tNone\n"
        "Status flags: MOVING MOVING_AZ MOVING_LEFT MOVING_RIGHT MOVING_EL MOVING_UP MOVING_DOWN "
        "LIMIT_UP LIMIT_DOWN LIMIT_LEFT LIMIT_RIGHT \n"
        "Get functions: \nSet functions: \n"
        "Get level: SPEED(1..4/1) \nSet level: SPEED(1..4/1) \n"
        "Get parameters: \nSet parameters: \n";
    text += "Min Azimuth:\t\t" + degrees(limits.minAzimuth);
    text += "Max Azimuth:\t\t" + degrees(limits.maxAzimuth);
    text += "Min Elevation:\t\t" + degrees(limits.minElevation);
    text += "Max Elevation:\t\t" + degrees(limits.maxElevation);
    text +=
        "Can set Conf:\t\tN\nCan get Conf:\t\tN\n"
        "Can set Position:\tY\nCan get Position:\tY\n"
        "Can Stop:\t\tY\nCan Park:\t\tY\nCan Reset:\t\tY\nCan Move:\t\tY\n"
        "Can get Info:\t\tY\nCan get Status:\t\tY\n"
        "Can set Func:\tN\nCan get Func:\tN\nCan set Level:\tY\nCan get Level:\tY\n"
        "Can set Param:\tN\nCan get Param:\tN\n"
        "\nOverall backend warnings: 0\n";
    reply.text(text);
}

}  // namespace

Result<> runInformation(const Command& command, const Context& context, ReplyWriter& reply)
{
    switch (command.spec->id) {
        case CommandId::GetInfo:
            reply.value(oneLine(context.rotator.info()));
            break;
        case CommandId::GetStatus:
            reply.value(flagWords(context.rotator.motion()));
            break;
        case CommandId::DumpState:
            dumpState(command, context, reply);
            break;
        case CommandId::DumpCapabilities:
            dumpCapabilities(context, reply);
            break;
        default:
            reply.text(helpText());
    }
    return {};
}

}  // namespace boresight::rotctld
