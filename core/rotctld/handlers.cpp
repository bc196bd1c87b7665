// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotctld/handlers.h"

#include "core/base/text.h"

namespace boresight::rotctld {

Result<> runCommand(const Command& command, const Context& context, ReplyWriter& reply)
{
    if (command.tooLong) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("an argument is longer than %1 characters").arg(QString::number(kMaxArgumentLength)));
    }
    switch (command.spec->id) {
        case CommandId::SetPosition:
        case CommandId::GetPosition:
        case CommandId::Park:
        case CommandId::Stop:
        case CommandId::Reset:
        case CommandId::Move:
            return runMotion(command, context, reply);
        case CommandId::SetLevel:
        case CommandId::GetLevel:
        case CommandId::SetFunction:
        case CommandId::GetFunction:
        case CommandId::SetParameter:
        case CommandId::GetParameter:
        case CommandId::SetConfiguration:
        case CommandId::SendRaw:
            return runSetting(command, context, reply);
        case CommandId::GetInfo:
        case CommandId::GetStatus:
        case CommandId::DumpCapabilities:
        case CommandId::DumpState:
        case CommandId::Help:
            return runInformation(command, context, reply);
        default:
            return runConversion(command, reply);
    }
}

tl::unexpected<Error> badArgument(const Command& command, std::size_t index)
{
    if (index >= command.argumentCount) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("%1 is missing").arg(toQString(command.spec->arguments[index])));
    }
    return failure(ErrorCode::InvalidInput,
                   Text::tr("%1 \"%2\" is not understood")
                       .arg(toQString(command.spec->arguments[index]), toQString(command.arguments[index])));
}

}  // namespace boresight::rotctld
