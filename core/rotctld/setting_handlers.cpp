// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text.h"
#include "core/rotctld/c_number.h"
#include "core/rotctld/handlers.h"

#include <algorithm>
#include <array>

// Levels, functions, parameters, configuration. A mount has one level, SPEED. It does not have the example items of
// Hamlib's dummy (MGL, MGEF, MGP …), so the lists of functions and parameters are empty. Clients may not change the
// configuration.
namespace boresight::rotctld {
namespace {

constexpr std::string_view kSpeed = "SPEED";

bool asksForNames(const Command& command)
{
    return command.arguments[0].starts_with('?');
}

Result<> setLevel(const Command& command, const Context& context)
{
    if (command.arguments[0] != kSpeed) {
        return failure(ErrorCode::NotAvailable,
                       Text::tr("there is no level \"%1\"").arg(toQString(command.arguments[0])));
    }
    const auto level = command.argumentCount > 1 ? leadingInteger(command.arguments[1]) : std::nullopt;
    return level ? context.rotator.setSpeedLevel(context.client, *level) : badArgument(command, 1);
}

Result<> level(const Command& command, const Context& context, ReplyWriter& reply)
{
    if (command.arguments[0] != kSpeed) {
        return badArgument(command, 0);
    }
    // Hamlib prints a level without label and with a line feed, even if the client asked for labels or another
    // separator.
    reply.text(std::to_string(context.rotator.speedLevel()) + "\n");
    return {};
}

Result<> setConfiguration(const Command& command, const Context& context)
{
    // In Hamlib every client may change the limits with these.
    constexpr std::array<std::string_view, 5> kLimits{"min_az", "max_az", "min_el", "max_el", "south_zero"};
    if (std::ranges::find(kLimits, command.arguments[0]) != kLimits.end()) {
        context.rotator.clientRemark(context.client,
                                     Text::tr("wanted to change %1: refused").arg(toQString(command.arguments[0])));
        return failure(ErrorCode::Refused, Text::tr("limits are set in the profile, not by clients"));
    }
    return badArgument(command, 0);
}

}  // namespace

Result<> runSetting(const Command& command, const Context& context, ReplyWriter& reply)
{
    const CommandId id = command.spec->id;
    if (id == CommandId::SendRaw) {
        return failure(ErrorCode::Io, Text::tr("raw commands to the drives are not permitted"));
    }
    if (id == CommandId::SetConfiguration) {
        return setConfiguration(command, context);
    }
    const bool levels = id == CommandId::SetLevel || id == CommandId::GetLevel;
    if (asksForNames(command)) {
        reply.text(levels ? "SPEED \n" : "\n");
        return {};
    }
    if (levels) {
        return id == CommandId::SetLevel ? setLevel(command, context) : level(command, context, reply);
    }
    if (id == CommandId::SetFunction) {
        return failure(ErrorCode::NotAvailable,
                       Text::tr("there is no function \"%1\"").arg(toQString(command.arguments[0])));
    }
    return badArgument(command, 0);
}

}  // namespace boresight::rotctld
