// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/overloaded.h"
#include "core/moteus/subframe_types.h"
#include "core/moteus/subframes.h"

#include <algorithm>

namespace boresight::moteus {
namespace {

// The registers at the front of `items` that can share one subframe.
template <class Item>
std::span<const Item> leadingGroup(std::span<const Item> items)
{
    const auto end = std::ranges::adjacent_find(
        items, [](const Item& a, const Item& b) { return b.reg != a.reg + 1 || b.resolution != a.resolution; });
    return end == items.end() ? items : items.first(static_cast<std::size_t>(end - items.begin()) + 1);
}

template <class Item>
BlockHeader headerOf(std::span<const Item> group)
{
    return {.resolution = group.front().resolution,
            .count = static_cast<std::uint32_t>(group.size()),
            .first = group.front().reg,
            .longCount = group.size() > type::kLargestShortCount};
}

}  // namespace

std::size_t varuintSize(std::uint32_t value)
{
    std::size_t size = 1;
    while (value > 0x7f) {
        value >>= 7;
        ++size;
    }
    return size;
}

ReadBlock takeBlock(std::span<const RegisterRead>& reads)
{
    const auto group = leadingGroup(reads);
    reads = reads.subspan(group.size());
    return {headerOf(group)};
}

std::size_t replySize(const ReadBlock& block)
{
    return 1 + (block.longCount ? varuintSize(block.count) : 0) + varuintSize(static_cast<std::uint32_t>(block.first)) +
           block.count * sizeInBytes(block.resolution);
}

std::span<const std::uint8_t> SubframeWriter::bytes() const
{
    return std::span(m_bytes).first(std::min(m_needed, m_bytes.size()));
}

void SubframeWriter::put(std::uint8_t byte)
{
    if (m_needed < m_bytes.size()) {
        m_bytes[m_needed] = byte;
    }
    ++m_needed;
}

void SubframeWriter::putVaruint(std::uint32_t value)
{
    while (value > 0x7f) {
        put(static_cast<std::uint8_t>(value | 0x80));
        value >>= 7;
    }
    put(static_cast<std::uint8_t>(value));
}

void SubframeWriter::putBytes(std::span<const std::uint8_t> bytes)
{
    for (const std::uint8_t byte : bytes) {
        put(byte);
    }
}

void SubframeWriter::putHeader(std::uint8_t base, const BlockHeader& header)
{
    const bool longCount = header.longCount || header.count == 0 || header.count > type::kLargestShortCount;
    const unsigned resolution = static_cast<unsigned>(header.resolution) << 2;
    put(static_cast<std::uint8_t>(base | resolution | (longCount ? 0 : header.count)));
    if (longCount) {
        putVaruint(header.count);
    }
    putVaruint(static_cast<std::uint32_t>(header.first));
}

void SubframeWriter::putValues(std::uint8_t base, std::span<const RegisterValue> values, Side side)
{
    while (!values.empty()) {
        const auto group = leadingGroup(values);
        putHeader(base, headerOf(group));
        for (const RegisterValue& item : group) {
            const Kind kind = registerKind(item.reg).value_or(Kind::Integer);
            std::uint32_t bits = toWire(item.value, kind, item.resolution, side);
            for (std::size_t i = 0; i < sizeInBytes(item.resolution); ++i) {
                put(static_cast<std::uint8_t>(bits));
                bits >>= 8;
            }
        }
        values = values.subspan(group.size());
    }
}

void SubframeWriter::appendWrites(std::span<const RegisterValue> writes, Side side)
{
    putValues(type::kWrite, writes, side);
}

void SubframeWriter::appendReplies(std::span<const RegisterValue> values, Side side)
{
    putValues(type::kReply, values, side);
}

void SubframeWriter::appendReads(std::span<const RegisterRead> reads)
{
    while (!reads.empty()) {
        putHeader(type::kRead, takeBlock(reads));
    }
}

void SubframeWriter::append(const Subframe& subframe)
{
    const auto putError = [this](std::uint8_t code, Register reg, std::uint32_t reason) {
        put(code);
        putVaruint(static_cast<std::uint32_t>(reg));
        putVaruint(reason);
    };
    const auto putTunnel = [this](std::uint8_t code, std::uint32_t channel, std::optional<std::uint8_t> number,
                                  std::size_t length) {
        put(code);
        putVaruint(channel);
        if (number) {
            put(*number);
        }
        putVaruint(static_cast<std::uint32_t>(length));
    };
    const auto putValueBlock = [this](std::uint8_t base, const ValueBlock& block) {
        putHeader(base, block);
        putBytes(block.bytes);
    };
    std::visit(
        Overloaded{
            [&](const ReadBlock& block) { putHeader(type::kRead, block); },
            [&](const WriteBlock& block) { putValueBlock(type::kWrite, block); },
            [&](const ReplyBlock& block) { putValueBlock(type::kReply, block); },
            [&](const WriteError& error) { putError(type::kWriteError, error.reg, error.code); },
            [&](const ReadError& error) { putError(type::kReadError, error.reg, error.code); },
            [&](const TunnelToDevice& text) {
                putTunnel(type::kTunnelToDevice, text.channel, std::nullopt, text.bytes.size());
                putBytes(text.bytes);
            },
            [&](const TunnelFromDevice& text) {
                putTunnel(type::kTunnelFromDevice, text.channel, std::nullopt, text.bytes.size());
                putBytes(text.bytes);
            },
            [&](const TunnelPoll& poll) { putTunnel(type::kTunnelPoll, poll.channel, std::nullopt, poll.maximum); },
            [&](const TunnelPacket& packet) {
                putTunnel(type::kTunnelPacket, packet.channel, packet.number, packet.bytes.size());
                putBytes(packet.bytes);
            },
            [&](const TunnelPollFlow& poll) {
                putTunnel(type::kTunnelPollFlow, poll.channel, poll.lastNumber, poll.maximum);
            },
            [&](const Nop&) { put(type::kNop); },
        },
        subframe);
}

}  // namespace boresight::moteus
