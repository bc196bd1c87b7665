// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus/codec.h"

#include "core/base/overloaded.h"
#include "core/base/text.h"

#include <algorithm>
#include <cmath>

namespace boresight::moteus {
namespace {

constexpr auto kI8 = Resolution::Int8;
constexpr auto kI16 = Resolution::Int16;
constexpr auto kI32 = Resolution::Int32;
constexpr auto kF32 = Resolution::Float;

// The number of values in rotatorQuery().
constexpr std::size_t kUsualValues = 16;

Result<> checkReadable(std::span<const RegisterRead> query)
{
    for (const RegisterRead& read : query) {
        if (!isReadable(read.reg)) {
            return failure(ErrorCode::InvalidInput,
                           QStringLiteral("%1 cannot be read").arg(toQString(registerName(read.reg))));
        }
        if (registerKind(read.reg) == Kind::Identity && read.resolution != kI32) {
            return failure(ErrorCode::InvalidInput,
                           QStringLiteral("%1 can only be read as i32").arg(toQString(registerName(read.reg))));
        }
    }
    return {};
}

Result<> checkRequest(const Request& request)
{
    if (request.destination == 0 || request.destination > kBroadcastId || request.source > kBroadcastId ||
        request.prefix > kMaxPrefix) {
        return failure(ErrorCode::OutOfRange,
                       QStringLiteral("moteus id outside 1..127, source outside 0..127 or prefix over 0x1fff"));
    }
    if (request.uuid && (request.uuid->words < 1 || request.uuid->words > 4)) {
        return failure(ErrorCode::OutOfRange, QStringLiteral("a UUID mask has 1 to 4 words"));
    }
    if (!request.query.empty() && !request.replyWanted) {
        return failure(ErrorCode::InvalidInput, QStringLiteral("a query needs a reply"));
    }
    return checkReadable(request.query).and_then([&] { return checkAnswerable(request.query); });
}

void appendUuid(SubframeWriter& writer, const UuidMask& mask)
{
    std::array<RegisterValue, 4> words;
    for (std::size_t i = 0; i < mask.words; ++i) {
        words[i] = {Register::UuidMask + static_cast<std::uint32_t>(i), kI32, static_cast<double>(mask.uuid[i])};
    }
    writer.appendWrites(std::span(words).first(mask.words));
}

std::string textOf(std::span<const std::uint8_t> bytes)
{
    return {bytes.begin(), bytes.end()};
}

// Keeps subframes that a device sends. Other subframes do not belong in a reply and are ignored.
void take(Reply& reply, const Subframe& subframe)
{
    std::visit(Overloaded{
                   [&](const ReplyBlock& block) {
                       for (std::uint32_t i = 0; i < block.count; ++i) {
                           reply.values.push_back(block.value(i));
                       }
                   },
                   [&](const WriteError& error) {
                       reply.errors.push_back({error.reg, error.code, true});
                   },
                   [&](const ReadError& error) {
                       reply.errors.push_back({error.reg, error.code, false});
                   },
                   [&](const TunnelFromDevice& text) {
                       reply.texts.push_back({text.channel, std::nullopt, textOf(text.bytes)});
                   },
                   [&](const TunnelPacket& packet) {
                       reply.texts.push_back({packet.channel, packet.number, textOf(packet.bytes)});
                   },
                   [](const auto&) {},
               },
               subframe);
}

}  // namespace

const Query& basicQuery()
{
    static const Query query{{Register::Mode, kI8},    {Register::Position, kF32}, {Register::Velocity, kF32},
                             {Register::Torque, kF32}, {Register::Voltage, kI8},   {Register::Temperature, kI8},
                             {Register::Fault, kI8}};
    return query;
}

const Query& rotatorQuery()
{
    static const Query query{{Register::Mode, kI8},
                             {Register::Position, kF32},
                             {Register::Velocity, kF32},
                             {Register::Torque, kF32},
                             {Register::QCurrent, kI16},
                             {Register::DCurrent, kI16},
                             {Register::Power, kI16},
                             {Register::ControlPosition, kF32},
                             {Register::ControlVelocity, kF32},
                             {Register::StayWithinLower, kI8},
                             // The largest block comes last, because no block may start after byte 41.
                             {Register::MotorTemperature, kI16},
                             {Register::TrajectoryComplete, kI16},
                             {Register::HomeState, kI16},
                             {Register::Voltage, kI16},
                             {Register::Temperature, kI16},
                             {Register::Fault, kI16}};
    return query;
}

const Query& discoveryQuery()
{
    static const Query query{{Register::Uuid, kI32},
                             {Register::Uuid + 1, kI32},
                             {Register::Uuid + 2, kI32},
                             {Register::Uuid + 3, kI32},
                             {Register::UuidMaskCapable, kI8}};
    return query;
}

const Query& versionQuery()
{
    static const Query query{
        {Register::ModelNumber, kI32}, {Register::FirmwareVersion, kI32}, {Register::RegisterMapVersion, kI32}};
    return query;
}

std::size_t replySize(std::span<const RegisterRead> query)
{
    std::size_t size = 0;
    while (!query.empty()) {
        size += replySize(takeBlock(query));
    }
    return size;
}

Result<> checkAnswerable(std::span<const RegisterRead> query)
{
    std::size_t size = 0;
    bool leftOut = false;
    while (!query.empty()) {
        leftOut = leftOut || size > kReplyBlockStartLimit;
        size += replySize(takeBlock(query));
    }
    if (size > kMaxCanPayload) {
        return failure(ErrorCode::OutOfRange, QStringLiteral("the reply would need %1 of 64 bytes").arg(size));
    }
    if (leftOut) {
        return failure(ErrorCode::OutOfRange,
                       QStringLiteral("the last part of the reply would start after byte %1 and be left out")
                           .arg(kReplyBlockStartLimit));
    }
    return {};
}

Result<CanFrame> encode(const Request& request)
{
    if (auto checked = checkRequest(request); !checked) {
        return tl::unexpected(checked.error());
    }
    SubframeWriter writer;
    if (request.uuid) {
        appendUuid(writer, *request.uuid);
    }
    if (request.command) {
        writer.appendWrites(registerWrites(*request.command));
    }
    writer.appendReads(request.query);
    if (writer.overflowed()) {
        return failure(ErrorCode::OutOfRange,
                       QStringLiteral("the request would need %1 of 64 bytes").arg(writer.needed()));
    }
    return makeFrame({.prefix = request.prefix,
                      .replyWanted = request.replyWanted,
                      .source = request.source,
                      .destination = request.destination},
                     writer.bytes());
}

Result<Reply> decodeReply(const CanFrame& frame)
{
    const Arbitration id = fromCanId(frame.id);
    if (id.replyWanted) {
        return failure(ErrorCode::Protocol,
                       QStringLiteral("a frame that wants a reply is not a reply: %1").arg(toQString(toString(frame))));
    }
    Reply reply;
    reply.source = id.source;
    reply.destination = id.destination;
    reply.prefix = id.prefix;
    reply.values.reserve(kUsualValues);
    SubframeReader reader(frame.payload());
    while (const auto subframe = reader.next()) {
        take(reply, *subframe);
    }
    reply.end = reader.end();
    return reply;
}

std::optional<double> Reply::value(Register reg) const
{
    const auto found = std::ranges::find(values, reg, &RegisterValue::reg);
    if (found == values.end() || !std::isfinite(found->value)) {
        return std::nullopt;
    }
    return found->value;
}

std::optional<Mode> Reply::mode() const
{
    const auto number = value(Register::Mode);
    if (!number || *number < 0 || *number >= kModeCount) {
        return std::nullopt;
    }
    return static_cast<Mode>(static_cast<int>(*number));
}

std::optional<int> Reply::fault() const
{
    const auto number = value(Register::Fault);
    if (!number || std::abs(*number) > 1e6) {
        return std::nullopt;
    }
    return static_cast<int>(*number);
}

std::optional<HomeState> Reply::homeState() const
{
    const auto number = value(Register::HomeState);
    if (!number || *number < 0 || *number > static_cast<int>(HomeState::Output)) {
        return std::nullopt;
    }
    return static_cast<HomeState>(static_cast<int>(*number));
}

std::optional<Uuid> Reply::uuid() const
{
    Uuid uuid{};
    for (std::uint32_t i = 0; i < uuid.size(); ++i) {
        const auto word = value(Register::Uuid + i);
        if (!word) {
            return std::nullopt;
        }
        uuid[i] = toWire(*word, Kind::Identity, Resolution::Int32);
    }
    return uuid;
}

}  // namespace boresight::moteus
