// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus/frame_server.h"

#include "core/base/overloaded.h"

#include <algorithm>
#include <array>
#include <utility>

namespace boresight::moteus {
namespace {

// The real server starts a subframe only while this much of the reply is free (so a reply grows until it has more than
// 41 bytes). It also keeps this much free after the text of the tunnel (so a poll alone in its frame brings at most 39
// bytes, or 38 with flow control).
constexpr std::size_t kReserve = 23;
constexpr std::size_t kMaxText = kMaxCanPayload - kReserve;

std::size_t textRoom(const SubframeWriter& reply, std::size_t header)
{
    const std::size_t taken = header + kReserve;
    return reply.room() > taken ? std::min(kMaxText, reply.room() - taken) : 0;
}

bool matchesUuid(ServedDevice& device, Register mask, std::uint32_t bits)
{
    const auto word = static_cast<std::uint32_t>(mask) - static_cast<std::uint32_t>(Register::UuidMask);
    return toWire(device.readRegister(Register::Uuid + word), Kind::Identity, Resolution::Int32) == bits;
}

bool isUuidMask(Register reg)
{
    return reg >= Register::UuidMask && reg < Register::UuidMask + 4;
}

std::uint32_t writeOne(ServedDevice& device, const RegisterValue& item)
{
    if (!registerKind(item.reg)) {
        return kUnknownRegister;
    }
    return isWritable(item.reg) ? device.writeRegister(item.reg, item.value) : kNotWritable;
}

bool canAnswer(Register reg, Resolution resolution)
{
    return isReadable(reg) && (registerKind(reg) != Kind::Identity || resolution == Resolution::Int32);
}

// The reply has the form of the request: the bit-rate switch is copied, and classic CAN is used while the reply fits.
CanFrame replyFrame(const CanFrame& request, DeviceAddress address, std::span<const std::uint8_t> payload)
{
    CanFrame reply = makeFrame({.prefix = address.prefix,
                                .replyWanted = false,
                                .source = address.id,
                                .destination = fromCanId(request.id).source},
                               payload);
    reply.flexibleData = request.flexibleData || reply.size > 8;
    reply.bitRateSwitch = reply.flexibleData && request.bitRateSwitch;
    return reply;
}

}  // namespace

std::optional<CanFrame> FrameServer::serve(const CanFrame& request, DeviceAddress address, ServedDevice& device)
{
    if (!isAddressedTo(request.id, address.id, address.prefix)) {
        return std::nullopt;
    }
    Exchange exchange{.device = device, .reply = {}, .replyWanted = fromCanId(request.id).replyWanted};
    SubframeReader reader(request.payload());
    Next next = Next::Continue;
    while (next == Next::Continue && exchange.reply.room() >= kReserve) {
        const auto subframe = reader.next();
        if (!subframe) {
            break;
        }
        next = serveSubframe(exchange, *subframe);
    }
    if (next == Next::Discard) {
        device.completeFrame(ServedDevice::FrameEnd::Discarded);
        return std::nullopt;
    }
    device.completeFrame(ServedDevice::FrameEnd::Accepted);
    if (!exchange.replyWanted) {
        return std::nullopt;
    }
    return replyFrame(request, address, exchange.reply.bytes());
}

FrameServer::Next FrameServer::serveSubframe(Exchange& exchange, const Subframe& subframe)
{
    return std::visit(Overloaded{
                          [](const Nop&) { return Next::Continue; },
                          [&](const WriteBlock& block) { return serveWrites(exchange, block); },
                          [&](const ReadBlock& block) { return serveReads(exchange, block); },
                          [&](const TunnelToDevice& text) {
                              if (exchange.device.hasChannel(text.channel)) {
                                  exchange.device.receiveText(text.channel, text.bytes);
                              }
                              return servePlainText(exchange, text.channel, kMaxText);
                          },
                          [&](const TunnelPoll& poll) { return servePlainText(exchange, poll.channel, poll.maximum); },
                          [&](const TunnelPollFlow& poll) { return serveFlowPoll(exchange, poll); },
                          [](const auto&) { return Next::EndFrame; },  // subframes that only a device may send
                      },
                      subframe);
}

FrameServer::Next FrameServer::serveWrites(Exchange& exchange, const WriteBlock& block)
{
    for (std::uint32_t i = 0; i < block.count; ++i) {
        const RegisterValue item = block.value(i, Side::Device);
        if (isUuidMask(item.reg) && block.resolution == Resolution::Int32) {
            if (!matchesUuid(exchange.device, item.reg, block.bits(i))) {
                return Next::Discard;
            }
            continue;
        }
        const std::uint32_t error = isUuidMask(item.reg) ? kUnknownRegister : writeOne(exchange.device, item);
        if (error != 0 && exchange.replyWanted && exchange.reply.room() >= kReserve) {
            exchange.reply.append(WriteError{item.reg, error});
        }
    }
    return Next::Continue;
}

FrameServer::Next FrameServer::serveReads(Exchange& exchange, const ReadBlock& block)
{
    if (!exchange.replyWanted) {
        return Next::Continue;
    }
    if (replySize(block) > exchange.reply.room()) {
        exchange.reply.append(ReadError{block.first, kNoRoom});
        return Next::Continue;
    }
    std::array<std::uint8_t, kMaxCanPayload> bytes{};
    std::size_t size = 0;
    for (std::uint32_t i = 0; i < block.count; ++i) {
        const Register reg = block.first + i;
        if (!canAnswer(reg, block.resolution)) {
            exchange.reply.append(ReadError{reg, kUnknownRegister});
            return Next::EndFrame;
        }
        std::uint32_t bits =
            toWire(exchange.device.readRegister(reg), *registerKind(reg), block.resolution, Side::Device);
        for (std::size_t part = 0; part < sizeInBytes(block.resolution); ++part) {
            bytes[size++] = static_cast<std::uint8_t>(bits);
            bits >>= 8;
        }
    }
    ReplyBlock reply;
    static_cast<BlockHeader&>(reply) = block;
    reply.bytes = std::span(bytes).first(size);
    exchange.reply.append(reply);
    return Next::Continue;
}

FrameServer::Next FrameServer::servePlainText(Exchange& exchange, std::uint32_t channel, std::size_t maximum)
{
    if (!exchange.device.hasChannel(channel)) {
        return Next::EndFrame;
    }
    if (!exchange.replyWanted) {
        return Next::Continue;
    }
    const auto pending = exchange.device.pendingText(channel);
    const std::size_t room = textRoom(exchange.reply, 1 + varuintSize(channel));
    const auto text = pending.first(std::min({pending.size(), maximum, room}));
    exchange.reply.append(TunnelFromDevice{channel, text});
    if (!text.empty()) {
        exchange.device.dropText(channel, text.size());
        m_flows[channel].unacknowledged = 0;
    }
    return Next::Continue;
}

FrameServer::Next FrameServer::serveFlowPoll(Exchange& exchange, const TunnelPollFlow& poll)
{
    if (!exchange.device.hasChannel(poll.channel)) {
        return Next::EndFrame;
    }
    if (!exchange.replyWanted) {
        return Next::Continue;
    }
    Flow& flow = m_flows[poll.channel];
    const std::size_t room = textRoom(exchange.reply, 2 + varuintSize(poll.channel));
    if (flow.unacknowledged == 0 || poll.lastNumber == flow.number) {
        exchange.device.dropText(poll.channel, std::exchange(flow.unacknowledged, 0));
        ++flow.number;
        flow.unacknowledged =
            std::min({exchange.device.pendingText(poll.channel).size(), std::size_t{poll.maximum}, room});
    }
    const auto pending = exchange.device.pendingText(poll.channel);
    const std::size_t size = std::min(flow.unacknowledged, pending.size());
    const std::size_t header = 3 + varuintSize(poll.channel);
    if (header + size > exchange.reply.room()) {
        return Next::EndFrame;  // a repeated packet that does not fit after the other subframes of this reply
    }
    exchange.reply.append(TunnelPacket{poll.channel, flow.number, pending.first(size)});
    return Next::Continue;
}

}  // namespace boresight::moteus
