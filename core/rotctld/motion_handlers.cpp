// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/rotctld/c_number.h"
#include "core/rotctld/handlers.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace boresight::rotctld {
namespace {

Result<> pointTo(const Command& command, const Context& context)
{
    const auto azimuth = leadingPosition(command.arguments[0]);
    if (!azimuth) {
        return badArgument(command, 0);
    }
    const auto elevation = command.argumentCount > 1 ? leadingPosition(command.arguments[1]) : std::nullopt;
    if (!elevation) {
        return badArgument(command, 1);
    }
    // More than any cable permits. Hamlib accepts any finite number here, but a direction of 1e38 degrees means
    // nothing.
    constexpr float kMostAzimuth = 3600.0F;
    if (std::abs(*azimuth) > kMostAzimuth) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("azimuth %1° is outside -3600°…3600°").arg(static_cast<double>(*azimuth), 0, 'g', 6));
    }
    constexpr float kLowest = -90.0F;
    constexpr float kHighest = 180.0F;
    if (*elevation < kLowest || *elevation > kHighest) {
        return failure(ErrorCode::InvalidInput, Text::tr("elevation %1° is outside -90°…180°")
                                                    .arg(toQString(formatFixed(static_cast<double>(*elevation), 2))));
    }
    const auto degrees = [](float value) { return Angle::fromDegrees(static_cast<double>(value)); };
    return context.rotator.pointTo(context.client, {.azimuth = degrees(*azimuth), .elevation = degrees(*elevation)})
        .map([&](const QString& became) { context.outcome = became; });
}

Result<> position(const Context& context, ReplyWriter& reply)
{
    const Result<SkyPointing> pointing = context.rotator.position(context.client);
    if (!pointing) {
        return tl::unexpected(pointing.error());
    }
    reply.value(formatFixed(pointing->azimuth.degrees(), 2));
    reply.value(formatFixed(pointing->elevation.degrees(), 2));
    return {};
}

std::optional<MoveDirection> moveDirection(std::string_view word)
{
    struct Word
    {
        std::string_view text;
        MoveDirection direction;
    };
    constexpr std::array kWords{
        Word{"UP", MoveDirection::Up},    Word{"2", MoveDirection::Up},        Word{"DOWN", MoveDirection::Down},
        Word{"4", MoveDirection::Down},   Word{"LEFT", MoveDirection::Left},   Word{"CCW", MoveDirection::Left},
        Word{"8", MoveDirection::Left},   Word{"RIGHT", MoveDirection::Right}, Word{"CW", MoveDirection::Right},
        Word{"16", MoveDirection::Right},
    };
    const auto* const found = std::ranges::find(kWords, word, &Word::text);
    return found == kWords.end() ? std::nullopt : std::optional(found->direction);
}

Result<> move(const Command& command, const Context& context)
{
    const auto direction = moveDirection(command.arguments[0]);
    if (!direction) {
        return badArgument(command, 0);
    }
    const auto speed = command.argumentCount > 1 ? leadingInteger(command.arguments[1]) : std::nullopt;
    return speed ? context.rotator.move(context.client, *direction, *speed) : badArgument(command, 1);
}

Result<> reset(const Command& command, const Context& context)
{
    const auto kind = leadingInteger(command.arguments[0]);
    return kind ? context.rotator.reset(context.client, *kind) : badArgument(command, 0);
}

}  // namespace

Result<> runMotion(const Command& command, const Context& context, ReplyWriter& reply)
{
    switch (command.spec->id) {
        case CommandId::SetPosition:
            return pointTo(command, context);
        case CommandId::GetPosition:
            return position(context, reply);
        case CommandId::Park:
            return context.rotator.park(context.client);
        case CommandId::Stop:
            return context.rotator.stop(context.client);
        case CommandId::Reset:
            return reset(command, context);
        default:
            return move(command, context);
    }
}

}  // namespace boresight::rotctld
