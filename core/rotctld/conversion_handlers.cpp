// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/rotctld/c_number.h"
#include "core/rotctld/conversions.h"
#include "core/rotctld/handlers.h"

#include <array>
#include <cmath>

namespace boresight::rotctld {
namespace {

std::string sixDecimals(double value)
{
    return formatFixed(value, 6);
}

// The values of a command with numeric arguments, up to `Count`.
template <std::size_t Count>
Result<std::array<double, Count>> numbers(const Command& command)
{
    std::array<double, Count> values{};
    for (std::size_t i = 0; i < Count; ++i) {
        const auto value = i < command.argumentCount ? leadingDouble(command.arguments[i]) : std::nullopt;
        if (!value) {
            return badArgument(command, i);
        }
        values[i] = *value;
    }
    return values;
}

Result<int> integer(const Command& command, std::size_t index)
{
    const auto value = index < command.argumentCount ? leadingInteger(command.arguments[index]) : std::nullopt;
    if (!value) {
        return badArgument(command, index);
    }
    return *value;
}

Result<> locator(const Command& command, ReplyWriter& reply)
{
    const auto place = numbers<2>(command);
    const auto length = integer(command, 2);
    if (!place || !length) {
        return tl::unexpected(place ? length.error() : place.error());
    }
    const auto text = toLocator({.longitude = (*place)[0], .latitude = (*place)[1]}, *length);
    if (!text) {
        return badArgument(command, 2);
    }
    reply.value(*text);
    return {};
}

Result<> place(const Command& command, ReplyWriter& reply)
{
    const auto centre = fromLocator(command.arguments[0]);
    if (!centre) {
        return badArgument(command, 0);
    }
    reply.value(sixDecimals(centre->longitude));
    reply.value(sixDecimals(centre->latitude));
    return {};
}

// D: degrees and minutes are whole numbers, seconds a fraction.
Result<> fromDms(const Command& command, ReplyWriter& reply)
{
    const auto degrees = integer(command, 0);
    const auto minutes = integer(command, 1);
    const auto negative = integer(command, 3);
    const auto values = numbers<3>(command);
    if (!degrees || !minutes || !negative || !values) {
        return badArgument(command, !degrees ? 0 : !minutes ? 1 : !values ? 2 : 3);
    }
    reply.value(sixDecimals(
        toDegrees({.degrees = *degrees, .minutes = *minutes, .seconds = (*values)[2], .negative = *negative == 1})));
    return {};
}

// E: like D, with the seconds as a fraction of the minutes. Hamlib 4.5.4 adds a second and loses the sign here.
Result<> fromMinutes(const Command& command, ReplyWriter& reply)
{
    const auto degrees = integer(command, 0);
    const auto negative = integer(command, 2);
    const auto values = numbers<2>(command);
    if (!degrees || !negative || !values) {
        return badArgument(command, !degrees ? 0 : !values ? 1 : 2);
    }
    constexpr double kSecondsPerMinute = 60.0;
    const double angle =
        toDegrees({.degrees = *degrees, .seconds = (*values)[1] * kSecondsPerMinute, .negative = *negative == 1});
    if (!std::isfinite(angle)) {
        return badArgument(command, 1);
    }
    reply.value(sixDecimals(angle));
    return {};
}

Result<> toDms(const Command& command, ReplyWriter& reply)
{
    const auto degrees = numbers<1>(command);
    if (!degrees) {
        return tl::unexpected(degrees.error());
    }
    const DegreesMinutesSeconds angle = toDegreesMinutesSeconds((*degrees)[0]);
    reply.value(std::to_string(angle.degrees));
    if (command.spec->id == CommandId::DegreesToDms) {
        reply.value(std::to_string(angle.minutes));
        reply.value(sixDecimals(angle.seconds));
    } else {
        reply.value(sixDecimals(angle.minutes + angle.seconds / 60.0));
    }
    reply.value(angle.negative ? "1" : "0");
    return {};
}

Result<> distanceAndAzimuth(const Command& command, ReplyWriter& reply)
{
    const auto values = numbers<4>(command);
    if (!values) {
        return tl::unexpected(values.error());
    }
    const auto& [fromLongitude, fromLatitude, toLongitude, toLatitude] = *values;
    const auto path = greatCircle({.longitude = fromLongitude, .latitude = fromLatitude},
                                  {.longitude = toLongitude, .latitude = toLatitude});
    if (!path) {
        return failure(ErrorCode::OutOfRange, Text::tr("a latitude or longitude is out of range"));
    }
    reply.value(sixDecimals(path->kilometres));
    reply.value(sixDecimals(path->azimuth));
    return {};
}

Result<> longPath(const Command& command, ReplyWriter& reply)
{
    const auto value = numbers<1>(command);
    if (!value) {
        return tl::unexpected(value.error());
    }
    const auto other =
        command.spec->id == CommandId::LongPathAzimuth ? longPathAzimuth((*value)[0]) : longPathDistance((*value)[0]);
    if (!other) {
        return badArgument(command, 0);
    }
    reply.value(sixDecimals(*other));
    return {};
}

}  // namespace

Result<> runConversion(const Command& command, ReplyWriter& reply)
{
    switch (command.spec->id) {
        case CommandId::ToLocator:
            return locator(command, reply);
        case CommandId::FromLocator:
            return place(command, reply);
        case CommandId::DmsToDegrees:
            return fromDms(command, reply);
        case CommandId::MinutesToDegrees:
            return fromMinutes(command, reply);
        case CommandId::DegreesToDms:
        case CommandId::DegreesToMinutes:
            return toDms(command, reply);
        case CommandId::GreatCircle:
            return distanceAndAzimuth(command, reply);
        default:
            return longPath(command, reply);
    }
}

}  // namespace boresight::rotctld
